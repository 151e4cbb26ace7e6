// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/MixJob.h"

#include "core/material/MapStack.h"
#include "core/noise/NoiseGrid.h"
#include "core/sheet/ContactSheet.h"

#include <algorithm>

namespace txn::app {
namespace {

constexpr int kNoisePreviewPx = 96;

QImage previewOf(const Image& image, const MaterialMaps& maps) {
    return toQImage(firstPicture(image, maps));
}

MixFrame frameOf(const MixedTexton& one, const MaterialMaps& maps) {
    MixFrame frame;
    frame.rho = one.rho;
    frame.pictures = mapPictures(textonPicture(one.texton, {0, 0}), maps);
    frame.texton = toQImage(frame.pictures.front().image());
    const auto noise = NoiseGrid::create(one.texton, {});
    if (const auto picture = noise ? noise->render({0, 0, {kNoisePreviewPx, kNoisePreviewPx}})
                                   : Result<Image>(noise.error()))
        frame.noise = previewOf(*picture, maps);
    return frame;
}

/// With the frames that there are already.
std::shared_ptr<MixResult>
resultOf(const MixSolver& solver, const MaterialMaps& maps, const MixResult* before) {
    auto result = std::make_shared<MixResult>();
    result->mixed = solver.result();
    result->maps = maps;
    result->distance = solver.path().distance();
    for (const MixedTexton& one : result->mixed.textons) {
        const MixFrame* known = nullptr;
        if (before != nullptr) {
            const auto at = std::ranges::find(before->frames, one.rho, &MixFrame::rho);
            known = at == before->frames.end() ? nullptr : &*at;
        }
        result->frames.push_back(known != nullptr ? *known : frameOf(one, maps));
    }
    return result;
}

} // namespace

Result<std::shared_ptr<const MixResult>>
computeMix(const MixInput& input,
           int textons,
           const std::shared_ptr<const MixResult>& known,
           JobContext& context,
           const std::function<void(std::shared_ptr<const MixResult>)>& publish) {
    const Exemplar& a = input.a->exemplar;
    const Exemplar& b = input.b->exemplar;
    auto solver = makeMixSolver({a,
                                 b,
                                 input.a->model.isPeriodicComponent(),
                                 input.b->model.isPeriodicComponent(),
                                 computeParams(input.settings),
                                 textons},
                                known ? known->mixed : MixedTextons{},
                                context.token());
    if (!solver)
        return solver.error();
    std::shared_ptr<MixResult> last = resultOf(*solver, a.maps, known.get());
    while (!solver->done()) {
        if (const auto ok = solver->step(context.token()); !ok)
            return ok.error();
        context.setProgress(solver->share());
        last = resultOf(*solver, a.maps, last.get());
        if (!solver->done())
            publish(last);
    }
    last->finished = true;
    return std::shared_ptr<const MixResult>(std::move(last));
}

std::shared_ptr<const MixResult> reversed(const MixResult& result) {
    auto made = std::make_shared<MixResult>(result);
    std::ranges::reverse(made->mixed.textons);
    std::ranges::reverse(made->mixed.anchors);
    std::ranges::reverse(made->frames);
    for (MixedTexton& one : made->mixed.textons) {
        one.rho = 1.0 - one.rho;
        one.distance = result.distance - one.distance;
    }
    for (MixFrame& frame : made->frames)
        frame.rho = 1.0 - frame.rho;
    return made;
}

} // namespace txn::app
