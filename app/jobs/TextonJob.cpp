// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/TextonJob.h"

#include "core/sheet/ContactSheet.h"

#include <QElapsedTimer>
#include <algorithm>

namespace txn::app {
namespace {

/// From one intermediate texton to the next: often enough to see it form, seldom enough that
/// drawing its noise takes little of what the fit needs, where the processor does both.
constexpr qint64 kOftenMs = 80;
constexpr qint64 kSeldomMs = 250;
qint64 pauseAfter(qint64 elapsedMs) {
    return std::clamp(elapsedMs / 4, kOftenMs, kSeldomMs);
}
/// Before that, a fit still looks like the noise it began with.
constexpr int kFirstUsable = 12;
/// From one point of the error curve to the next.
constexpr double kCurveSpacing = 1.25;

std::shared_ptr<TextonResult> toResult(Texton texton, const MaterialMaps& maps) {
    auto result = std::make_shared<TextonResult>();
    // One pixel of the picture per coefficient, whatever the limit.
    result->pictures = mapPictures(textonPicture(texton, {0, 0}), maps);
    result->maps = maps;
    result->texton = std::move(texton);
    return result;
}

} // namespace

Result<std::shared_ptr<const TextonResult>>
computeTexton(const ExemplarResult& exemplar,
              const TextonSettings& settings,
              JobContext& context,
              const std::function<void(std::shared_ptr<const TextonResult>)>& publish) {
    QElapsedTimer watch;
    watch.start();
    const ComputeParams params = computeParams(settings);
    std::vector<ErrorPoint> curve;
    qint64 published = -kOftenMs;
    int iterations = 0;
    const auto observe = [&](const ComputeProgress& now) {
        iterations = now.iteration;
        context.setProgress(now.share);
        // Measuring may cost half an iteration, so the points get sparser as the curve gets
        // flatter.
        if (!now.choosingKernels &&
            (curve.empty() || now.iteration >= kCurveSpacing * curve.back().iteration))
            curve.push_back({now.iteration, now.error()});
        const bool usable = params.method == TextonMethod::Projections ||
                            now.iteration >= std::min(kFirstUsable, now.iterations);
        if (!usable || now.share >= 1.0 ||
            watch.elapsed() - published < pauseAfter(watch.elapsed()))
            return;
        auto made = toResult(now.texton(), exemplar.exemplar.maps);
        made->curve = curve;
        made->iteration = now.iteration;
        made->iterations = now.iterations;
        made->method = params.method;
        made->choosingKernels = now.choosingKernels;
        made->error = now.error();
        publish(std::move(made));
        published = watch.elapsed();
    };
    auto computed =
        txn::computeTexton(exemplar.exemplar, exemplar.model, params, observe, context.token());
    if (!computed)
        return computed.error().code == ErrorCode::Cancelled
                   ? computed.error()
                   : Error{computed.error().code,
                           txn::quoted(std::filesystem::path(exemplar.exemplar.name)) + ": " +
                               computed.error().message};
    auto result = toResult(std::move(computed->texton), exemplar.exemplar.maps);
    if (curve.empty() || curve.back().iteration != iterations)
        curve.push_back({iterations, computed->error});
    result->curve = std::move(curve);
    result->iteration = iterations;
    result->iterations = iterations;
    result->method = params.method;
    result->error = computed->error;
    result->relativeModelError = computed->relativeModelError;
    result->trialErrors = std::move(computed->trialErrors);
    if (const auto dial = covarianceError(exemplar.exemplar, result->texton))
        result->dial = *dial;
    result->finished = true;
    return std::shared_ptr<const TextonResult>(std::move(result));
}

std::shared_ptr<const TextonResult> importedTexton(const TextonAsset& asset) {
    auto made = toResult(asset.texton, asset.maps);
    made->finished = true;
    made->imported = true;
    return made;
}

Texton adjusted(Texton texton, const MaterialMaps& maps, double contrast, double brightness) {
    // Of a stack, only the colors: lighter normals are nonsense.
    const auto color = findMap(maps, MapKind::Color);
    const auto isColor = [&](int c) {
        return maps.empty() || (color && c >= firstChannel(maps, *color) &&
                                c < firstChannel(maps, *color) + maps[*color].channels);
    };
    for (Image& kernel : texton.kernels) {
        for (int c = 0; c < kernel.channels(); ++c) {
            if (!isColor(c))
                continue;
            for (float& v : kernel.plane(c))
                v *= static_cast<float>(contrast);
        }
    }
    for (int c = 0; c < texton.channels(); ++c) {
        if (isColor(c))
            texton.mean[static_cast<std::size_t>(c)] += brightness;
    }
    return texton;
}

} // namespace txn::app
