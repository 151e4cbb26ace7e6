// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/AnalysisJob.h"

#include "core/image/ImageGeometry.h"
#include "core/noise/NoiseGrid.h"

#include <algorithm>

namespace txn::app {
namespace {

constexpr int kMaxSidePx = 1024;

/// Its middle, where it is larger than that.
Image middle(const Image& image) {
    const Size size{std::min(image.width(), kMaxSidePx), std::min(image.height(), kMaxSidePx)};
    if (size == image.size())
        return image;
    auto part =
        crop(image, {(image.width() - size.width) / 2, (image.height() - size.height) / 2, size});
    if (!part)
        return image;
    return std::move(*part);
}

} // namespace

Result<std::shared_ptr<const AnalysisResult>> analyseAll(const ExemplarResult& exemplar,
                                                         const GaussianResult& gaussian,
                                                         const Texton& texton,
                                                         const NoiseParams& noise,
                                                         JobContext& context) {
    const Error cancelled{ErrorCode::Cancelled, "cancelled"};
    const Image original = middle(exemplar.exemplar.image);
    auto result = std::make_shared<AnalysisResult>();
    result->exemplar = analyseTexture(original);
    context.setProgress(0.3);
    if (context.cancelled())
        return cancelled;
    result->gaussian = analyseTexture(middle(gaussian.image));
    context.setProgress(0.6);
    if (context.cancelled())
        return cancelled;
    auto grid = NoiseGrid::create(texton, noise);
    if (!grid)
        return grid.error();
    const auto rendered = grid->render({0, 0, original.size()}, context.token());
    if (!rendered)
        return rendered.error();
    context.setProgress(0.8);
    result->noise = analyseTexture(*rendered);
    return std::shared_ptr<const AnalysisResult>(std::move(result));
}

} // namespace txn::app
