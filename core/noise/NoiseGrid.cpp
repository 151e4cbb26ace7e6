// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/NoiseGrid.h"

#include "core/noise/MixedProcess.h"

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

/// Of the kernels' spectra; with more, kernels are added up one by one.
constexpr std::size_t kMostConvolutionBytes = std::size_t{3} << 30U;

std::int64_t floorDivide(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/// Copies the common part of a tile and the rectangle.
void copyOverlap(
    const Image& tile, std::int64_t tileX, std::int64_t tileY, const Rect& rect, Image& out) {
    const std::int64_t x0 = std::max(tileX, rect.x);
    const std::int64_t x1 = std::min(tileX + tile.width(), rect.x + rect.size.width);
    const std::int64_t y0 = std::max(tileY, rect.y);
    const std::int64_t y1 = std::min(tileY + tile.height(), rect.y + rect.size.height);
    for (int c = 0; c < tile.channels(); ++c) {
        for (std::int64_t y = y0; y < y1; ++y) {
            const auto from = tile.row(c, static_cast<int>(y - tileY));
            const auto to = out.row(c, static_cast<int>(y - rect.y));
            std::copy(from.begin() + (x0 - tileX),
                      from.begin() + (x1 - tileX),
                      to.begin() + (x0 - rect.x));
        }
    }
}

} // namespace

Result<NoiseGrid> NoiseGrid::create(Mixture mixture, const NoiseParams& params, double scale) {
    if (const auto ok = checkMixedNoise(mixture, params); !ok)
        return ok.error();
    if (!(scale >= kMinScale && scale <= kMaxScale))
        return Error{ErrorCode::InvalidArgument, "the scale must be between 1/64 and 64"};
    const int channels = mixture.textons.front().channels();
    const Transfer transfer = mixture.textons.front().transfer;
    // At exactly one output pixel per exemplar pixel the cheap convolution applies.
    const bool unit =
        std::abs(scale - 1.0) < 1e-12 && convolutionBytes(mixture) <= kMostConvolutionBytes;
    return NoiseGrid(unit ? makeConvolutionEvaluator(std::move(mixture), params)
                          : makeScaledEvaluator(std::move(mixture), params, scale),
                     channels,
                     transfer,
                     scale);
}

Result<Image> NoiseGrid::render(const Rect& rect, const CancelToken& cancel) const {
    if (rect.size.width < 1 || rect.size.height < 1)
        return Error{ErrorCode::InvalidArgument, "width and height must be at least 1"};
    const double farthest = NoiseParams::kFarthest * m_scale;
    const auto inside = [&](std::int64_t start, int length) {
        return static_cast<double>(start) >= -farthest &&
               static_cast<double>(start) + length <= farthest;
    };
    if (!inside(rect.x, rect.size.width) || !inside(rect.y, rect.size.height))
        return Error{ErrorCode::InvalidArgument,
                     "that part of the plane is more than 1e8 exemplar pixels away"};

    Image out(rect.size, m_channels, 0.0F, m_transfer);
    const Size tile = tileSize();
    const std::int64_t x0 = floorDivide(rect.x, tile.width);
    const std::int64_t y0 = floorDivide(rect.y, tile.height);
    const std::int64_t x1 = floorDivide(rect.x + rect.size.width - 1, tile.width) + 1;
    const std::int64_t y1 = floorDivide(rect.y + rect.size.height - 1, tile.height) + 1;
    tbb::enumerable_thread_specific<Image> scratch([&] { return Image(tile, m_channels); });
    tbb::parallel_for(tbb::blocked_range2d<std::int64_t>(y0, y1, 1, x0, x1, 1),
                      [&](const auto& range) {
                          Image& local = scratch.local();
                          for (auto y = range.rows().begin(); y != range.rows().end(); ++y) {
                              for (auto x = range.cols().begin(); x != range.cols().end(); ++x) {
                                  if (cancel.cancelled())
                                      return;
                                  m_evaluator->evaluate(x, y, local, cancel);
                                  copyOverlap(local, x * tile.width, y * tile.height, rect, out);
                              }
                          }
                      });
    if (cancel.cancelled())
        return Error{ErrorCode::Cancelled, "cancelled"};
    return out;
}

} // namespace txn
