// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Marks a hot loop of plain arithmetic: compiled once for every x86-64 machine and again for those
/// with AVX2 and AVX-512, chosen when the program starts: by what the machine can do, since names
/// of processors would leave out all others. Sanitizers run before that choice can.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(TXN_SANITIZED)
#define TXN_MULTIVERSION                                                                           \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define TXN_MULTIVERSION
#endif
