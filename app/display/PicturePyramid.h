// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <QImage>
#include <memory>
#include <optional>
#include <vector>

namespace txn::app {

/// How samples become light.
struct DisplaySettings {
    double exposure = 0.0;      ///< in stops, applied in linear light
    std::optional<int> channel; ///< this one alone, as grey; unset: all

    bool operator==(const DisplaySettings&) const = default;
};

/// Which part of a picture is seen: device pixel (0, 0) has its corner at (left, top).
struct PictureWindow {
    QSize size;        ///< in device pixels
    double left = 0.0; ///< in pixels of the picture
    double top = 0.0;
    double zoom = 1.0; ///< device pixels per pixel of the picture
    bool tiled = false;

    bool operator==(const PictureWindow&) const = default;
};

/// A picture with its halves, quarters and so on (means of 2 x 2 samples as stored), so that any
/// part of it is drawn at any zoom in a time that depends on the drawn pixels only. Immutable;
/// building takes time and belongs into a job, drawing does not.
class PicturePyramid {
  public:
    explicit PicturePyramid(Image image);

    const Image& image() const { return m_levels.front(); }
    /// ARGB32, premultiplied; outside the picture transparent. Pixels are squares from zoom 2 on,
    /// smoothed below. Grey for one channel, the first three of more; two are red and green.
    [[nodiscard]] QImage draw(const PictureWindow& window, const DisplaySettings& display) const;

  private:
    std::vector<Image> m_levels;
};

/// The whole image as 8-bit sRGB, for thumbnails and saving. ARGB32, premultiplied, opaque.
[[nodiscard]] QImage toQImage(const Image& image, const DisplaySettings& display = {});

} // namespace txn::app
