// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <bit>
#include <filesystem>
#include <fstream>
#include <vector>

namespace txn::test {

/// A file of float64 values, little endian; empty if it cannot be read.
inline std::vector<double> readArray(const std::filesystem::path& path) {
    static_assert(std::endian::native == std::endian::little);
    std::ifstream stream(path, std::ios::binary | std::ios::ate);
    if (!stream)
        return {};
    std::vector<double> values(static_cast<std::size_t>(stream.tellg()) / sizeof(double));
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(values.data()),
                static_cast<std::streamsize>(values.size() * sizeof(double)));
    return values;
}

/// Row-major H x W x C values as an image; empty if the count is wrong.
inline Image imageFromArray(const std::vector<double>& values, Size size, int channels) {
    if (values.size() != size.area() * static_cast<std::size_t>(channels))
        return {};
    Image image(size, channels);
    std::size_t i = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (int c = 0; c < channels; ++c)
                image.at(x, y, c) = static_cast<float>(values[i++]);
        }
    }
    return image;
}

/// The samples in the order of the arrays.
inline std::vector<double> arrayFromImage(const Image& image) {
    std::vector<double> values;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 0; c < image.channels(); ++c)
                values.push_back(static_cast<double>(image.at(x, y, c)));
        }
    }
    return values;
}

} // namespace txn::test
