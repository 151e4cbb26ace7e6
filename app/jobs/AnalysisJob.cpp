// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/AnalysisJob.h"

#include "core/image/ImageGeometry.h"
#include "core/material/MapStack.h"
#include "core/noise/NoiseGrid.h"

namespace txn::app {
namespace {

constexpr Size kLargest{1024, 1024};

} // namespace

Result<std::shared_ptr<const AnalysisResult>> analyseAll(const ExemplarResult& exemplar,
                                                         const GaussianResult& gaussian,
                                                         const Texton& texton,
                                                         const NoiseParams& noise,
                                                         JobContext& context) {
    const Error cancelled{ErrorCode::Cancelled, "cancelled"};
    const Image original = middlePart(exemplar.pictures.front().image(), kLargest);
    auto result = std::make_shared<AnalysisResult>();
    result->exemplar = analyseTexture(original);
    context.setProgress(0.3);
    if (context.cancelled())
        return cancelled;
    result->gaussian = analyseTexture(middlePart(gaussian.pictures.front().image(), kLargest));
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
    result->noise = analyseTexture(firstPicture(*rendered, exemplar.exemplar.maps));
    return std::shared_ptr<const AnalysisResult>(std::move(result));
}

} // namespace txn::app
