// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display/PicturePyramid.h"

#include "app/memory/NewImage.h"
#include "core/image/ColorTransfer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace txn::app {
namespace {

/// The next level: half the size, rounded up; a last odd row or column counts as it is.
Image halved(const Image& image) {
    const Size size{(image.width() + 1) / 2, (image.height() + 1) / 2};
    Image half(size, image.channels(), 0.0F, image.transfer());
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = 0; y < size.height; ++y) {
            const auto top = image.row(c, 2 * y);
            const auto bottom = image.row(c, std::min(2 * y + 1, image.height() - 1));
            const auto out = half.row(c, y);
            const std::size_t pairs = top.size() / 2;
            for (std::size_t x = 0; x < pairs; ++x)
                out[x] = 0.25F * (top[2 * x] + top[2 * x + 1] + bottom[2 * x] + bottom[2 * x + 1]);
            if (pairs < out.size())
                out[pairs] = 0.5F * (top[2 * pairs] + bottom[2 * pairs]);
        }
    }
    return half;
}

/// From samples to bytes of the screen, by table: exact to a fraction of a byte's step.
class ToScreen {
  public:
    ToScreen(Transfer transfer, double exposure) {
        const double gain = std::exp2(exposure);
        for (std::size_t i = 0; i < m_table.size(); ++i) {
            const auto v = static_cast<float>(i) / (kSteps - 1);
            float shown = v;
            if (transfer == Transfer::Linear || exposure != 0.0) {
                const float light = transfer == Transfer::Linear ? v : linearFromEncoded(v);
                shown = encodedFromLinear(static_cast<float>(light * gain));
            }
            m_table[i] =
                static_cast<std::uint8_t>(std::lround(std::clamp(shown, 0.0F, 1.0F) * 255.0F));
        }
        // Above 1, a darker exposure may still show something.
        m_range = gain < 1.0 ? static_cast<float>(1.0 / gain) : 1.0F;
        if (m_range > 1.0F)
            fillRange(transfer, gain);
    }
    std::uint8_t operator()(float v) const {
        const float place = v * m_scale;
        // False for NaN, which is shown black.
        return place > 0.0F ? m_table[static_cast<std::size_t>(std::min(place, kLast))]
                            : m_table[0];
    }

  private:
    static constexpr std::size_t kSteps = 8192;
    static constexpr float kLast = static_cast<float>(kSteps - 1);

    void fillRange(Transfer transfer, double gain) {
        const float top = transfer == Transfer::Linear ? m_range : encodedFromLinear(m_range);
        m_scale = kLast / top;
        for (std::size_t i = 0; i < m_table.size(); ++i) {
            const float v = static_cast<float>(i) / m_scale;
            const float light = transfer == Transfer::Linear ? v : linearFromEncoded(v);
            const float shown = encodedFromLinear(static_cast<float>(light * gain));
            m_table[i] =
                static_cast<std::uint8_t>(std::lround(std::clamp(shown, 0.0F, 1.0F) * 255.0F));
        }
    }

    std::array<std::uint8_t, kSteps> m_table{};
    float m_range = 1.0F;
    float m_scale = kLast;
};

/// Which channels are red, green and blue; -1: none.
std::array<int, 3> shownChannels(int channels, const DisplaySettings& display) {
    if (display.channel) {
        const int c = std::clamp(*display.channel, 0, channels - 1);
        return {c, c, c};
    }
    if (channels == 1)
        return {0, 0, 0};
    return {0, 1, channels == 2 ? -1 : 2};
}

/// Where a device pixel falls on a row or column of the level: two neighbours and a weight.
struct Tap {
    int first = -1; ///< -1: outside
    int second = 0;
    float weight = 0.0F; ///< of the second
};

int wrapped(int i, int n) {
    const int rest = i % n;
    return rest < 0 ? rest + n : rest;
}

/// full: pixels of the picture; level: of its level.
std::vector<Tap> taps(int count, double start, double zoom, int full, int level, bool tiled) {
    std::vector<Tap> result(static_cast<std::size_t>(count));
    const double shrink = static_cast<double>(level) / full;
    const bool crisp = zoom >= 2.0;
    for (int i = 0; i < count; ++i) {
        const double place = start + (i + 0.5) / zoom; // on the picture
        if (!tiled && !(place >= 0.0 && place < full))
            continue;
        const double inside = tiled ? place - full * std::floor(place / full) : place;
        Tap& tap = result[static_cast<std::size_t>(i)];
        if (crisp) {
            tap.first = tap.second = std::min(static_cast<int>(inside), level - 1);
            continue;
        }
        const double at = inside * shrink - 0.5;
        const int low = static_cast<int>(std::floor(at));
        tap.weight = static_cast<float>(at - low);
        tap.first = tiled ? wrapped(low, level) : std::clamp(low, 0, level - 1);
        tap.second = tiled ? wrapped(low + 1, level) : std::clamp(low + 1, 0, level - 1);
    }
    return result;
}

} // namespace

PicturePyramid::PicturePyramid(Image image) {
    m_levels.push_back(std::move(image));
    while (m_levels.back().width() > 1 || m_levels.back().height() > 1)
        m_levels.push_back(halved(m_levels.back()));
}

QImage PicturePyramid::draw(const PictureWindow& window, const DisplaySettings& display) const {
    if (window.size.isEmpty() || !(window.zoom > 0.0))
        return {};
    // The smallest level that is not smaller than what is shown of it.
    std::size_t index = 0;
    for (double zoom = window.zoom; zoom <= 0.5 && index + 1 < m_levels.size(); zoom *= 2.0)
        ++index;
    const Image& level = m_levels[index];
    const Size full = image().size();
    const auto across = taps(window.size.width(),
                             window.left,
                             window.zoom,
                             full.width,
                             level.width(),
                             window.tiled);
    const auto down = taps(window.size.height(),
                           window.top,
                           window.zoom,
                           full.height,
                           level.height(),
                           window.tiled);
    const ToScreen toScreen(level.transfer(), display.exposure);
    const auto channels = shownChannels(level.channels(), display);
    const bool gray = channels[0] == channels[1] && channels[1] == channels[2];

    QImage result = newImage(window.size, QImage::Format_ARGB32_Premultiplied);
    result.fill(Qt::transparent);
    for (int y = 0; y < window.size.height(); ++y) {
        const Tap& row = down[static_cast<std::size_t>(y)];
        if (row.first < 0)
            continue;
        auto* out = reinterpret_cast<QRgb*>(result.scanLine(y));
        for (std::size_t k = 0; k < channels.size(); ++k) {
            if (channels[k] < 0 || (gray && k > 0))
                continue;
            const auto top = level.row(channels[k], row.first);
            const auto bottom = level.row(channels[k], row.second);
            const int shift = 16 - 8 * static_cast<int>(k);
            for (std::size_t x = 0; x < across.size(); ++x) {
                const Tap& tap = across[x];
                if (tap.first < 0)
                    continue;
                const auto a = static_cast<std::size_t>(tap.first);
                const auto b = static_cast<std::size_t>(tap.second);
                const float upper = top[a] + tap.weight * (top[b] - top[a]);
                const float lower = bottom[a] + tap.weight * (bottom[b] - bottom[a]);
                const QRgb byte = toScreen(upper + row.weight * (lower - upper));
                out[x] |= 0xff000000U | (gray ? byte * 0x010101U : byte << shift);
            }
        }
    }
    return result;
}

QImage toQImage(const Image& image, const DisplaySettings& display) {
    QImage result = newImage({image.width(), image.height()}, QImage::Format_ARGB32_Premultiplied);
    const ToScreen toScreen(image.transfer(), display.exposure);
    const auto channels = shownChannels(image.channels(), display);
    for (int y = 0; y < image.height(); ++y) {
        auto* out = reinterpret_cast<QRgb*>(result.scanLine(y));
        std::fill_n(out, image.width(), 0xff000000U);
        for (std::size_t k = 0; k < channels.size(); ++k) {
            if (channels[k] < 0)
                continue;
            const auto row = image.row(channels[k], y);
            const int shift = 16 - 8 * static_cast<int>(k);
            for (std::size_t x = 0; x < row.size(); ++x)
                out[x] |= static_cast<QRgb>(toScreen(row[x])) << shift;
        }
    }
    return result;
}

} // namespace txn::app
