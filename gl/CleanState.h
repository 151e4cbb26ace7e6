// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace txn {

/// Sets what a caller may have changed of OpenGL's state, and what would spoil our pictures, to
/// what OpenGL starts with.
void startFromDefaults();

/// The same for reading pixels back and for uploading them.
void usePlainPixels();

} // namespace txn
