// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vector>

namespace txn {
namespace {

constexpr int kRadius = 3;
constexpr int kTaps = 2 * kRadius;
constexpr int kPhases = 1024;
using Weights = std::array<float, kTaps>;

double lanczos(double x) {
    if (std::abs(x) < 1e-9)
        return 1.0;
    if (std::abs(x) >= kRadius)
        return 0.0;
    const double a = std::numbers::pi * x;
    return kRadius * std::sin(a) * std::sin(a / kRadius) / (a * a);
}

/// Weights of the samples at floor(x) - 2 ... floor(x) + 3, one row per fraction of x. Each row
/// sums to 1, so that a constant stays one.
std::vector<Weights> lanczosTable() {
    std::vector<Weights> table(kPhases + 1);
    for (int phase = 0; phase <= kPhases; ++phase) {
        std::array<double, kTaps> weights{};
        double sum = 0.0;
        for (int tap = 0; tap < kTaps; ++tap) {
            const auto i = static_cast<std::size_t>(tap);
            weights[i] = lanczos(static_cast<double>(phase) / kPhases - (tap - kRadius + 1));
            sum += weights[i];
        }
        for (std::size_t i = 0; i < kTaps; ++i)
            table[static_cast<std::size_t>(phase)][i] = static_cast<float>(weights[i] / sum);
    }
    return table;
}

/// Where to read along one axis: the six nearest samples, those outside replaced by the border.
struct Reach {
    std::array<int, kTaps> index{};
    const Weights* weights = nullptr;
};

Reach reach(double position, int size, const std::vector<Weights>& table) {
    const double base = std::floor(position);
    const auto phase = std::lround((position - base) * kPhases);
    Reach result;
    result.weights = &table[static_cast<std::size_t>(std::clamp<long>(phase, 0, kPhases))];
    for (int tap = 0; tap < kTaps; ++tap)
        result.index[static_cast<std::size_t>(tap)] =
            std::clamp(static_cast<int>(base) + tap - kRadius + 1, 0, size - 1);
    return result;
}

/// The largest upright rectangle inside a w x h one turned by an angle, not a multiple of 90
/// degrees: either two of its corners touch the long sides, or all four touch a side each.
Size innerRectangle(double w, double h, double angle) {
    const double sine = std::abs(std::sin(angle));
    const double cosine = std::abs(std::cos(angle));
    const double longSide = std::max(w, h);
    const double shortSide = std::min(w, h);
    double width = 0.0;
    double height = 0.0;
    if (shortSide <= 2.0 * sine * cosine * longSide || std::abs(sine - cosine) < 1e-10) {
        const double half = 0.5 * shortSide;
        width = w >= h ? half / sine : half / cosine;
        height = w >= h ? half / cosine : half / sine;
    } else {
        const double twice = cosine * cosine - sine * sine;
        width = (w * cosine - h * sine) / twice;
        height = (h * cosine - w * sine) / twice;
    }
    // Rounding must not take a row from a picture turned by next to nothing.
    return {static_cast<int>(width + 1e-6), static_cast<int>(height + 1e-6)};
}

} // namespace

Result<Image> crop(const Image& image, const Rect& rect) {
    const bool inside = rect.size.width > 0 && rect.size.height > 0 && rect.x >= 0 && rect.y >= 0 &&
                        rect.size.width <= image.width() && rect.size.height <= image.height() &&
                        rect.x <= image.width() - rect.size.width &&
                        rect.y <= image.height() - rect.size.height;
    if (!inside)
        return Error{ErrorCode::InvalidArgument,
                     "cannot crop to " + std::to_string(rect.size.width) + " x " +
                         std::to_string(rect.size.height) + " at (" + std::to_string(rect.x) +
                         ", " + std::to_string(rect.y) + "): the image is " +
                         std::to_string(image.width()) + " x " + std::to_string(image.height())};
    Image result(rect.size, image.channels(), 0.0F, image.transfer());
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = 0; y < rect.size.height; ++y) {
            const auto source = image.row(c, static_cast<int>(rect.y) + y)
                                    .subspan(static_cast<std::size_t>(rect.x),
                                             static_cast<std::size_t>(rect.size.width));
            std::copy(source.begin(), source.end(), result.row(c, y).begin());
        }
    }
    return result;
}

Image middlePart(const Image& image, Size atMost) {
    const Size size{std::min(image.width(), atMost.width), std::min(image.height(), atMost.height)};
    // It lies inside.
    return *crop(image,
                 {(image.width() - size.width) / 2, (image.height() - size.height) / 2, size});
}

std::pair<Image, Image> halves(const Image& image, bool leftRight) {
    const Size size = leftRight ? Size{image.width() / 2, image.height()}
                                : Size{image.width(), image.height() / 2};
    // Both lie inside.
    return {*crop(image, {0, 0, size}),
            *crop(image, {image.width() - size.width, image.height() - size.height, size})};
}

Result<Image>
rotated(const Image& image, double degreesCounterClockwise, const CancelToken& cancel) {
    if (!std::isfinite(degreesCounterClockwise))
        return Error{ErrorCode::InvalidArgument, "cannot rotate by an angle that is not a number"};
    const double degrees = std::remainder(degreesCounterClockwise, 360.0);
    const double quarters = std::round(degrees / 90.0);
    if (std::abs(degrees - 90.0 * quarters) < 1e-9) {
        // EXIF says what must be done to the stored image: 6 is a quarter turn clockwise.
        constexpr std::array kOrientations{1, 8, 3, 6};
        return upright(image, kOrientations[static_cast<std::size_t>(quarters + 4.0) % 4]);
    }

    const double angle = degrees * std::numbers::pi / 180.0;
    const Size size = innerRectangle(image.width(), image.height(), angle);
    if (size.width < 1 || size.height < 1)
        return Error{ErrorCode::InvalidArgument,
                     "nothing is left of an image of " + std::to_string(image.width()) + " x " +
                         std::to_string(image.height()) + " rotated by " +
                         std::to_string(degreesCounterClockwise) + " degrees"};
    Image result(size, image.channels(), 0.0F, image.transfer());
    const auto table = lanczosTable();
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    tbb::parallel_for(tbb::blocked_range<int>(0, size.height, 8), [&](const auto& rows) {
        for (int y = rows.begin(); y != rows.end() && !cancel.cancelled(); ++y) {
            const double dy = y + 0.5 - 0.5 * size.height;
            for (int x = 0; x < size.width; ++x) {
                const double dx = x + 0.5 - 0.5 * size.width;
                // y points down, so that this is the inverse of a turn counterclockwise.
                const auto across = reach(dx * cosine - dy * sine + 0.5 * image.width() - 0.5,
                                          image.width(),
                                          table);
                const auto down = reach(dx * sine + dy * cosine + 0.5 * image.height() - 0.5,
                                        image.height(),
                                        table);
                for (int c = 0; c < image.channels(); ++c) {
                    float sum = 0.0F;
                    for (std::size_t i = 0; i < kTaps; ++i) {
                        const auto row = image.row(c, down.index[i]);
                        float line = 0.0F;
                        for (std::size_t j = 0; j < kTaps; ++j)
                            line += (*across.weights)[j] *
                                    row[static_cast<std::size_t>(across.index[j])];
                        sum += (*down.weights)[i] * line;
                    }
                    result.at(x, y, c) = sum;
                }
            }
        }
    });
    if (cancel.cancelled())
        return Error{ErrorCode::Cancelled, "cancelled"};
    return result;
}

Image upright(Image image, int exifOrientation) {
    if (exifOrientation < 2 || exifOrientation > 8)
        return image;
    const bool swapped = exifOrientation >= 5;
    const int width = image.width();
    const int height = image.height();
    const Size size = swapped ? Size{height, width} : Size{width, height};
    // Which way the stored columns and rows run when read by the result's x and y.
    const bool mirrorX = exifOrientation == 2 || exifOrientation == 3 || exifOrientation == 7 ||
                         exifOrientation == 8;
    const bool mirrorY = exifOrientation == 3 || exifOrientation == 4 || exifOrientation == 6 ||
                         exifOrientation == 7;
    Image result(size, image.channels(), 0.0F, image.transfer());
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = 0; y < size.height; ++y) {
            const auto row = result.row(c, y);
            for (int x = 0; x < size.width; ++x) {
                const int storedX = swapped ? y : x;
                const int storedY = swapped ? x : y;
                row[static_cast<std::size_t>(x)] =
                    image.at(mirrorX ? width - 1 - storedX : storedX,
                             mirrorY ? height - 1 - storedY : storedY,
                             c);
            }
        }
    }
    return result;
}

} // namespace txn
