// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/FileDescriptor.h"

namespace txn {

/// The life of the program `texton-decode`: decodes the pictures that the other end of the socket
/// sends until it is closed, and writes them into the pipe. Before the first one this process gives
/// up what decoding does not need: it may write no file, keep few files open, leave no core dump;
/// memory and processor time are bounded anew for each picture by its size. False where socket is
/// none. Not to be called in a program that does anything else.
[[nodiscard]] bool serveDecoding(FileDescriptor socket, FileDescriptor pipe);

} // namespace txn
