// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/MeshPromises.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace txn::fuzz {
namespace {

template <class Number>
void append(std::string& bytes, Number number, bool swap) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (swap)
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

std::string binary(bool big) {
    std::string bytes = std::string("ply\nformat ") +
                        (big ? "binary_big_endian" : "binary_little_endian") +
                        " 1.0\ncomment binary\nelement vertex 4\nproperty float x\nproperty double "
                        "y\nproperty short z\nproperty float s\nproperty float t\nelement face 2\n"
                        "property uchar material\nproperty list uchar uint vertex_index\n"
                        "end_header\n";
    const bool swap = big == (std::endian::native == std::endian::little);
    for (const auto& [x, y] : {std::pair(0.0F, 0.0), {1.0F, 0.0}, {1.0F, 1.0}, {0.0F, 1.0}}) {
        append(bytes, x, swap);
        append(bytes, y, swap);
        append(bytes, std::int16_t{7}, swap);
        append(bytes, x, swap);
        append(bytes, static_cast<float>(y), swap);
    }
    for (const auto& corners : {std::vector<std::uint32_t>{0, 1, 2}, {0, 1, 2, 3}}) {
        append(bytes, std::uint8_t{9}, swap);
        append(bytes, static_cast<std::uint8_t>(corners.size()), swap);
        for (const std::uint32_t corner : corners)
            append(bytes, corner, swap);
    }
    return bytes;
}

} // namespace

bool readOne(std::string_view bytes) {
    return keepsPromises(readMesh(std::string(bytes), "fuzz.ply"));
}

std::vector<std::string> seeds() {
    return {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
            "float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face "
            "1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 "
            "0 0 0 2\n3 0 1 2\n",
            binary(false),
            binary(true)};
}

} // namespace txn::fuzz
