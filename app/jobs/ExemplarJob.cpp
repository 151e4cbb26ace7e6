// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/ExemplarJob.h"

#include "app/threads/Background.h"
#include "core/gaussian/ExemplarEdits.h"
#include "core/image/ColorTransfer.h"
#include "core/image/ImageGeometry.h"
#include "core/material/MapStack.h"
#include "core/spectral/PeriodicComponent.h"

#include <algorithm>
#include <utility>

namespace txn::app {
namespace {

constexpr int kOverviewPx = 1024;
constexpr int kPreviewPx = 384;
constexpr int kSeamPx = 192;

/// The whole picture, at most side pixels wide and high.
QImage overview(const PicturePyramid& picture, int side) {
    const Size size = picture.image().size();
    const double zoom =
        std::min(1.0, static_cast<double>(side) / std::max(size.width, size.height));
    PictureWindow window;
    window.size = QSize(std::max(1, static_cast<int>(size.width * zoom)),
                        std::max(1, static_cast<int>(size.height * zoom)));
    window.zoom = zoom;
    return picture.draw(window, {});
}

/// Where the corners of four repeated pictures meet.
QImage seam(const PicturePyramid& picture) {
    const Size size = picture.image().size();
    PictureWindow window;
    window.size = QSize(std::min(kSeamPx, size.width), std::min(kSeamPx, size.height));
    window.left = size.width - window.size.width() / 2.0;
    window.top = size.height - window.size.height() / 2.0;
    window.tiled = true;
    return picture.draw(window, {});
}

/// The edits in their order, on an exemplar whose samples are all numbers. Sets beforeFlattening if
/// the lighting is evened.
Result<Exemplar> edited(Exemplar exemplar,
                        const ExemplarEdit& edit,
                        std::optional<Image>& beforeFlattening,
                        JobContext& context) {
    if (edit.flipGreen)
        flipGreen(exemplar.image, exemplar.maps);
    if (edit.straightenDegrees != 0.0) {
        auto upright = turned(std::move(exemplar), edit.straightenDegrees, context.token());
        if (!upright)
            return upright;
        exemplar = std::move(*upright);
    }
    context.setProgress(0.2);
    if (edit.flattenRadiusPx) {
        beforeFlattening = firstPicture(exemplar.image, exemplar.maps);
        auto even = lightingEvened(std::move(exemplar), *edit.flattenRadiusPx, context.token());
        if (!even)
            return even;
        exemplar = std::move(*even);
    }
    context.setProgress(0.4);
    if (edit.linear && exemplar.maps.empty())
        exemplar.image = toLinear(std::move(exemplar.image));
    return exemplar;
}

} // namespace

Result<std::shared_ptr<const ExemplarResult>> makeExemplarResult(
    const std::shared_ptr<const Source>& source, const ExemplarEdit& edit, JobContext& context) {
    const std::string name = source->name().toStdString();
    const auto named = [&](const Error& error) {
        return error.code == ErrorCode::Cancelled
                   ? error
                   : Error{error.code, quoted(std::filesystem::path(name)) + ": " + error.message};
    };
    const Error cancelled{ErrorCode::Cancelled, "cancelled"};

    const auto whole = source->picture();
    if (!whole)
        return whole.error();
    if (context.cancelled())
        return cancelled;
    const Image& picture = (*whole)->image;
    auto part = edit.crop ? crop(picture, *edit.crop) : Result<Image>(picture);
    if (!part)
        return named(part.error());
    // Before samples that are not numbers can spread by filtering.
    auto checked = makeExemplar(std::move(*part), name, source->maps());
    if (!checked)
        return checked.error();
    context.setProgress(0.1);
    if (context.cancelled())
        return cancelled;
    std::optional<Image> beforeFlattening;
    auto changed = edited(std::move(*checked), edit, beforeFlattening, context);
    if (!changed)
        return named(changed.error());
    auto exemplar = makeExemplar(std::move(changed->image), name, std::move(changed->maps));
    if (!exemplar)
        return exemplar.error();
    if (context.cancelled())
        return cancelled;
    GaussianModel model(*exemplar, edit.periodic);
    context.setProgress(0.7);
    if (context.cancelled())
        return cancelled;
    MapPictures pictures = mapPictures(exemplar->image, exemplar->maps);
    context.setProgress(0.8);
    if (context.cancelled())
        return cancelled;
    auto result = std::make_shared<ExemplarResult>(ExemplarResult{source,
                                                                  std::move(*exemplar),
                                                                  std::move(model),
                                                                  std::move(pictures),
                                                                  {},
                                                                  {},
                                                                  {},
                                                                  {},
                                                                  {}});
    result->evenAfter = overview(result->pictures.front(), kPreviewPx);
    result->evenBefore = beforeFlattening
                             ? overview(PicturePyramid(std::move(*beforeFlattening)), kPreviewPx)
                             : result->evenAfter;
    result->seamBefore = seam(result->pictures.front());
    context.setProgress(0.9);
    if (context.cancelled())
        return cancelled;
    result->overview = overview(PicturePyramid(firstPicture(picture, source->maps())), kOverviewPx);
    if (context.cancelled())
        return cancelled;
    result->seamAfter = seam(PicturePyramid(periodicComponent(result->pictures.front().image())));
    return freedInBackground<ExemplarResult>(std::move(result));
}

} // namespace txn::app
