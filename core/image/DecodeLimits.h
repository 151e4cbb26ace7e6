// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace txn {

/// What decoding one picture may cost. The decoder's process bounds itself; the program that waits
/// for it ends it when it does not answer in time. Internal to core/image.

/// Assumed until the header has been read.
inline constexpr std::uint64_t kSamplesBeforeHeader = std::uint64_t{1} << 22U;

/// How long the program waits, generous to a busy machine: decoders need about 10 ns a sample.
[[nodiscard]] std::chrono::milliseconds decodingTime(std::uint64_t fileBytes,
                                                     std::uint64_t samples);

/// Bounds memory and processor time from now on. Only in the decoder's process.
void limitDecoding(std::uint64_t fileBytes, std::uint64_t samples);

/// No writing to files, no new programs, no network, few open files, no core dump, and the first
/// to go when the system runs out of memory. For ever. Only in the decoder's process.
void giveUpRights();

/// Gives memory that is not in use back to the system.
void freeUnused();

} // namespace txn
