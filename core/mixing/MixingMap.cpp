// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mixing/MixingMap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace txn {
namespace {

Result<void> checkRho(const Image& rho, const std::string& what) {
    if (rho.empty() || rho.channels() != 1)
        return Error{ErrorCode::SizeMismatch, what + " must have one channel"};
    if (rho.width() > MixingMap::kMaxSide || rho.height() > MixingMap::kMaxSide)
        return Error{ErrorCode::TooLarge,
                     what + " is larger than " + std::to_string(MixingMap::kMaxSide) +
                         " pixels; scale it down"};
    const auto samples = rho.samples();
    const auto bad =
        std::ranges::find_if(samples, [](float v) { return !(v >= 0.0F && v <= 1.0F); });
    if (bad == samples.end())
        return {};
    const auto at = static_cast<std::size_t>(bad - samples.begin());
    const auto width = static_cast<std::size_t>(rho.width());
    return Error{ErrorCode::Degenerate,
                 what + " has a value that is not between 0 and 1 at x " +
                     std::to_string(at % width) + ", y " + std::to_string(at / width) +
                     "; 0 stands for A and 1 for B"};
}

} // namespace

Result<void> checkMixingMap(const MixingMap& map) {
    const MapPlacement& p = map.placement;
    if (!(p.width > 0.0 && p.height > 0.0 && std::isfinite(p.width) && std::isfinite(p.height) &&
          std::isfinite(p.left) && std::isfinite(p.top)))
        return Error{ErrorCode::InvalidArgument, "the rectangle of the mixing map is empty"};
    return checkRho(map.rho, "the mixing map");
}

Image gradientMap(Size size, double degreesClockwise, Ease ease) {
    const double angle = degreesClockwise * std::numbers::pi / 180.0;
    // Multiples of 90 degrees exactly.
    const auto exact = [](double v) { return std::abs(v) < 1e-12 ? 0.0 : v; };
    const double across = exact(std::cos(angle));
    const double down = exact(std::sin(angle));
    const double length = std::abs(across) * size.width + std::abs(down) * size.height;
    Image map(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double along =
                across * (x + 0.5 - 0.5 * size.width) + down * (y + 0.5 - 0.5 * size.height);
            const double t = std::clamp(0.5 + along / length, 0.0, 1.0);
            map.at(x, y, 0) =
                static_cast<float>(ease == Ease::Smooth ? t * t * (3.0 - 2.0 * t) : t);
        }
    }
    return map;
}

Result<Image> mapFromPicture(const Image& picture, const std::string& name) {
    const std::string what = "the mixing map '" + name + "'";
    if (picture.channels() != 1 && picture.channels() != 3)
        return Error{ErrorCode::Unsupported,
                     what + " has " + std::to_string(picture.channels()) +
                         " channels; save it as a grey picture"};
    Image rho(picture.size(), 1);
    std::ranges::copy(picture.plane(0), rho.samples().begin());
    for (int c = 1; c < picture.channels(); ++c) {
        // Whatever is not a number is told below.
        if (!std::ranges::equal(rho.samples(), picture.plane(c), [](float a, float b) {
                return a == b || (std::isnan(a) && std::isnan(b));
            }))
            return Error{ErrorCode::Unsupported, what + " is in color; save it as a grey picture"};
    }
    if (const auto ok = checkRho(rho, what); !ok)
        return ok.error();
    return rho;
}

} // namespace txn
