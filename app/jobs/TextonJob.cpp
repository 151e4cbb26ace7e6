// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/TextonJob.h"

#include "core/sheet/ContactSheet.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/TextonSolver.h"

#include <QElapsedTimer>

namespace txn::app {
namespace {

/// Often enough to see the texton form, seldom enough to cost little.
constexpr qint64 kPublishEveryMs = 80;
/// From one point of the error curve to the next.
constexpr double kCurveSpacing = 1.25;

std::shared_ptr<TextonResult> toResult(Texton texton) {
    // One pixel of the picture per coefficient, whatever the limit.
    PicturePyramid picture(textonPicture(texton, {0, 0}));
    return std::make_shared<TextonResult>(
        TextonResult{std::move(texton), std::move(picture), {}, 0, 0, 0.0, false, false});
}

} // namespace

Result<std::shared_ptr<const TextonResult>>
computeTexton(const ExemplarResult& exemplar,
              const TextonSettings& settings,
              JobContext& context,
              const std::function<void(std::shared_ptr<const TextonResult>)>& publish) {
    QElapsedTimer watch;
    watch.start();
    auto solver = TextonSolver::create(exemplar.model, textonParams(settings));
    if (!solver)
        return Error{solver.error().code,
                     txn::quoted(std::filesystem::path(exemplar.exemplar.name)) + ": " +
                         solver.error().message};
    std::vector<ErrorPoint> curve;
    // Measuring costs half an iteration, so the points get sparser as the curve gets flatter.
    const auto measure = [&] {
        if (curve.empty() || curve.back().iteration != solver->iteration())
            curve.push_back({solver->iteration(), solver->relativeModelError()});
    };
    const auto result = [&] {
        Texton texton = solver->texton();
        if (settings.colorCorrection)
            texton = colorCorrected(texton, exemplar.model.covariance());
        auto made = toResult(std::move(texton));
        measure();
        made->curve = curve;
        made->iteration = solver->iteration();
        made->iterations = settings.iterations;
        made->relativeModelError = settings.colorCorrection
                                       ? solver->relativeModelError(made->texton)
                                       : curve.back().relativeModelError;
        made->finished = solver->done();
        return made;
    };
    qint64 published = -kPublishEveryMs;
    while (!solver->done()) {
        if (context.cancelled())
            return Error{ErrorCode::Cancelled, "cancelled"};
        solver->step();
        if (curve.empty() || solver->iteration() >= kCurveSpacing * curve.back().iteration)
            measure();
        context.setProgress(static_cast<double>(solver->iteration()) / settings.iterations);
        if (!solver->done() && watch.elapsed() - published >= kPublishEveryMs) {
            publish(result());
            published = watch.elapsed();
        }
    }
    return std::shared_ptr<const TextonResult>(result());
}

std::shared_ptr<const TextonResult> importedTexton(const TextonAsset& asset) {
    auto made = toResult(asset.texton);
    made->finished = true;
    made->imported = true;
    return made;
}

Texton adjusted(Texton texton, double contrast, double brightness) {
    for (Image& kernel : texton.kernels) {
        for (float& v : kernel.samples())
            v *= static_cast<float>(contrast);
    }
    for (double& mean : texton.mean)
        mean += brightness;
    return texton;
}

} // namespace txn::app
