// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/ExemplarJob.h"

#include "app/memory/Background.h"
#include "core/image/ColorTransfer.h"
#include "core/image/ImageGeometry.h"
#include "core/spectral/Lighting.h"
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
Result<Image> edited(Image image,
                     const ExemplarEdit& edit,
                     std::optional<Image>& beforeFlattening,
                     JobContext& context) {
    if (edit.straightenDegrees != 0.0) {
        auto turned = rotated(image, edit.straightenDegrees, context.token());
        if (!turned)
            return turned;
        image = std::move(*turned);
    }
    context.setProgress(0.2);
    if (edit.flattenRadiusPx) {
        auto flat = flattenLighting(image, *edit.flattenRadiusPx, context.token());
        if (!flat)
            return flat;
        beforeFlattening = std::exchange(image, std::move(*flat));
    }
    context.setProgress(0.4);
    return edit.linear ? toLinear(std::move(image)) : std::move(image);
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
    auto checked = makeExemplar(std::move(*part), name);
    if (!checked)
        return checked.error();
    context.setProgress(0.1);
    if (context.cancelled())
        return cancelled;
    std::optional<Image> beforeFlattening;
    auto image = edited(std::move(checked->image), edit, beforeFlattening, context);
    if (!image)
        return named(image.error());
    auto exemplar = makeExemplar(std::move(*image), name);
    if (!exemplar)
        return exemplar.error();
    if (context.cancelled())
        return cancelled;
    GaussianModel model(*exemplar, edit.periodic);
    context.setProgress(0.7);
    if (context.cancelled())
        return cancelled;
    PicturePyramid pyramid(exemplar->image);
    context.setProgress(0.8);
    if (context.cancelled())
        return cancelled;
    auto result = std::make_shared<ExemplarResult>(ExemplarResult{source,
                                                                  std::move(*exemplar),
                                                                  std::move(model),
                                                                  std::move(pyramid),
                                                                  {},
                                                                  {},
                                                                  {},
                                                                  {},
                                                                  {}});
    result->evenAfter = overview(result->picture, kPreviewPx);
    result->evenBefore = beforeFlattening
                             ? overview(PicturePyramid(std::move(*beforeFlattening)), kPreviewPx)
                             : result->evenAfter;
    result->seamBefore = seam(result->picture);
    context.setProgress(0.9);
    if (context.cancelled())
        return cancelled;
    result->overview = overview(PicturePyramid(picture), kOverviewPx);
    if (context.cancelled())
        return cancelled;
    result->seamAfter = seam(PicturePyramid(periodicComponent(result->exemplar.image)));
    return freedInBackground<ExemplarResult>(std::move(result));
}

} // namespace txn::app
