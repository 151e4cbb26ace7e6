// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/IccProfile.h"

#include <algorithm>
#include <cmath>
#include <lcms2.h>
#include <limits>
#include <memory>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <type_traits>
#include <vector>

namespace txn {
namespace {

template <auto Delete>
struct Deleter {
    template <class T>
    void operator()(T* handle) const {
        Delete(handle);
    }
};
using Context = std::unique_ptr<std::remove_pointer_t<cmsContext>, Deleter<cmsDeleteContext>>;
using Profile = std::unique_ptr<std::remove_pointer_t<cmsHPROFILE>, Deleter<cmsCloseProfile>>;
using Transform =
    std::unique_ptr<std::remove_pointer_t<cmsHTRANSFORM>, Deleter<cmsDeleteTransform>>;

constexpr float kSameColor = 1.0F / 1024.0F;

/// sRGB, or for one channel a grey of the same curve.
Profile srgbProfile(cmsContext context, int channels) {
    if (channels == 3)
        return Profile(cmsCreate_sRGBProfileTHR(context));
    const cmsFloat64Number curve[5] = {2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045};
    cmsToneCurve* tone = cmsBuildParametricToneCurve(context, 4, curve);
    if (tone == nullptr)
        return nullptr;
    Profile profile(cmsCreateGrayProfileTHR(context, cmsD50_xyY(), tone));
    cmsFreeToneCurve(tone);
    return profile;
}

/// Whether the transform leaves a grid of colors where they are.
bool changesNothing(cmsHTRANSFORM transform, int channels) {
    const int steps = channels == 3 ? 9 : 65;
    std::vector<float> grid;
    for (int r = 0; r < steps; ++r) {
        const auto value = [&](int i) {
            return static_cast<float>(i) / static_cast<float>(steps - 1);
        };
        if (channels == 1) {
            grid.push_back(value(r));
            continue;
        }
        for (int g = 0; g < steps; ++g) {
            for (int b = 0; b < steps; ++b)
                grid.insert(grid.end(), {value(r), value(g), value(b)});
        }
    }
    std::vector<float> converted(grid.size());
    cmsDoTransform(transform,
                   grid.data(),
                   converted.data(),
                   static_cast<cmsUInt32Number>(grid.size() / static_cast<std::size_t>(channels)));
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (!(std::abs(converted[i] - grid[i]) <= kSameColor))
            return false;
    }
    return true;
}

void apply(Image& image, cmsHTRANSFORM transform) {
    const auto width = static_cast<std::size_t>(image.width());
    const auto channels = static_cast<std::size_t>(image.channels());
    tbb::parallel_for(tbb::blocked_range<int>(0, image.height(), 8),
                      [&](const tbb::blocked_range<int>& rows) {
                          std::vector<float> pixels(width * channels);
                          for (int y = rows.begin(); y != rows.end(); ++y) {
                              for (int c = 0; c < image.channels(); ++c) {
                                  const auto row = image.row(c, y);
                                  for (std::size_t x = 0; x < width; ++x)
                                      pixels[x * channels + static_cast<std::size_t>(c)] = row[x];
                              }
                              cmsDoTransform(transform,
                                             pixels.data(),
                                             pixels.data(),
                                             static_cast<cmsUInt32Number>(width));
                              for (int c = 0; c < image.channels(); ++c) {
                                  const auto row = image.row(c, y);
                                  for (std::size_t x = 0; x < width; ++x)
                                      row[x] = pixels[x * channels + static_cast<std::size_t>(c)];
                              }
                          }
                      });
}

} // namespace

bool convertToSrgb(Image& image, std::span<const std::uint8_t> profile) {
    const int channels = image.channels();
    if ((channels != 1 && channels != 3) || profile.empty() ||
        profile.size() > std::numeric_limits<cmsUInt32Number>::max())
        return false;
    const Context context(cmsCreateContext(nullptr, nullptr));
    if (!context)
        return false;
    const Profile source(cmsOpenProfileFromMemTHR(context.get(),
                                                  profile.data(),
                                                  static_cast<cmsUInt32Number>(profile.size())));
    const auto space = channels == 3 ? cmsSigRgbData : cmsSigGrayData;
    if (!source || cmsGetColorSpace(source.get()) != space)
        return false;
    const Profile target = srgbProfile(context.get(), channels);
    if (!target)
        return false;
    const cmsUInt32Number layout = channels == 3 ? TYPE_RGB_FLT : TYPE_GRAY_FLT;
    // Without the one-pixel cache a transform may be used by several threads.
    const Transform transform(cmsCreateTransformTHR(context.get(),
                                                    source.get(),
                                                    layout,
                                                    target.get(),
                                                    layout,
                                                    INTENT_RELATIVE_COLORIMETRIC,
                                                    cmsFLAGS_NOCACHE));
    if (!transform || changesNothing(transform.get(), channels))
        return false;
    apply(image, transform.get());
    return true;
}

} // namespace txn
