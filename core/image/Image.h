// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"

#include <cassert>
#include <span>
#include <vector>

namespace txn {

/// What sample values mean. Encoded: as in a photograph's file (sRGB transfer curve), or data that
/// has no curve. Linear: proportional to light.
enum class Transfer { Encoded, Linear };

/// H x W samples of C >= 1 channels, float, planar, row-major, y down. 1 is white; values may lie
/// outside [0, 1]. A regular value type.
class Image {
  public:
    Image() = default;
    Image(Size size, int channels, float value = 0.0F, Transfer transfer = Transfer::Encoded)
        : m_size(size), m_channels(channels), m_transfer(transfer),
          m_samples(size.area() * static_cast<std::size_t>(channels), value) {
        assert(size.width > 0 && size.height > 0 && channels > 0);
    }

    Size size() const { return m_size; }
    int width() const { return m_size.width; }
    int height() const { return m_size.height; }
    int channels() const { return m_channels; }
    bool empty() const { return m_samples.empty(); }

    Transfer transfer() const { return m_transfer; }
    void setTransfer(Transfer transfer) { m_transfer = transfer; }

    /// All W * H samples of one channel, row after row.
    std::span<float> plane(int channel) {
        return {m_samples.data() + offset(channel), m_size.area()};
    }
    std::span<const float> plane(int channel) const {
        return {m_samples.data() + offset(channel), m_size.area()};
    }
    std::span<float> row(int channel, int y) {
        return plane(channel).subspan(rowOffset(y), static_cast<std::size_t>(m_size.width));
    }
    std::span<const float> row(int channel, int y) const {
        return plane(channel).subspan(rowOffset(y), static_cast<std::size_t>(m_size.width));
    }

    float& at(int x, int y, int channel) {
        return plane(channel)[rowOffset(y) + static_cast<std::size_t>(x)];
    }
    float at(int x, int y, int channel) const {
        return plane(channel)[rowOffset(y) + static_cast<std::size_t>(x)];
    }

    /// Every sample, channel after channel.
    std::span<float> samples() { return m_samples; }
    std::span<const float> samples() const { return m_samples; }

    bool operator==(const Image&) const = default;

  private:
    std::size_t offset(int channel) const {
        assert(channel >= 0 && channel < m_channels);
        return static_cast<std::size_t>(channel) * m_size.area();
    }
    std::size_t rowOffset(int y) const {
        assert(y >= 0 && y < m_size.height);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width);
    }

    Size m_size;
    int m_channels = 0;
    Transfer m_transfer = Transfer::Encoded;
    std::vector<float> m_samples;
};

} // namespace txn
