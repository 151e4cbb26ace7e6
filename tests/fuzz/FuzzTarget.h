// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace txn::fuzz {

// What each file Fuzz*.cpp defines. It is linked twice: with libFuzzer, which looks for bytes that
// break it, and with Replay.cpp, which shows it the bytes that once did.

/// Reads the bytes as that kind of file. Whether they were accepted; ends the program where what
/// was accepted breaks a promise of the reader's.
bool readOne(std::string_view bytes);

/// Sound files, made by the program's own writers where there are any.
std::vector<std::string> seeds();

inline void require(bool promise, const char* what) {
    if (promise)
        return;
    std::fprintf(stderr, "the reader breaks its promise: %s\n", what);
    std::abort();
}

} // namespace txn::fuzz
