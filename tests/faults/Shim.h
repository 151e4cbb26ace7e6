// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <dlfcn.h>

namespace txn::test {

// What Shim.cpp offers to the program that it is preloaded into; without it nothing happens.

inline bool hasShim() {
    return ::dlsym(RTLD_DEFAULT, "txnSetFault") != nullptr;
}

/// fault: as TXN_FAULT, or nullptr for none. Whether the call that was to fail before has come.
inline bool
setFault(const char* fault, const char* under = "", bool nameless = true, bool hardLinks = true) {
    auto* set = reinterpret_cast<int (*)(const char*, const char*, int, int)>(
        ::dlsym(RTLD_DEFAULT, "txnSetFault"));
    return set != nullptr && set(fault, under, nameless ? 1 : 0, hardLinks ? 1 : 0) != 0;
}

/// After `left` more allocations of at least `atLeast` bytes all others of that size fail; below 0
/// none does any more. How many failed since the last call.
inline long failMemory(long left, std::size_t atLeast) {
    auto* fail =
        reinterpret_cast<long (*)(long, std::size_t)>(::dlsym(RTLD_DEFAULT, "txnFailMemory"));
    return fail != nullptr ? fail(left, atLeast) : 0;
}

} // namespace txn::test
