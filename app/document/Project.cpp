// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Project.h"

namespace txn::app {

MaterialMaps mapsOf(const Project& project) {
    if (project.source)
        return project.source->maps();
    return project.importedTexton ? project.importedTexton->maps : MaterialMaps{};
}

NoiseProcess mixedProcess(NoiseProcess process) {
    return process == NoiseProcess::Poisson ? NoiseProcess::Signed : process;
}

MapPlacement mapPlacement(const MixSettings& mix) {
    const Size size = mix.map.size();
    const double width = size.width * mix.mapScale;
    const double height = size.height * mix.mapScale;
    return {-0.5 * width, -0.5 * height, width, height};
}

ComputeParams computeParams(const TextonSettings& settings) {
    ComputeParams params;
    params.method = settings.method;
    if (settings.kernels != TextonSettings::kAutomatic)
        params.kernels = settings.kernels;
    switch (settings.shape) {
    case TextonSettings::Shape::Square:
        params.support = Support::rectangle({settings.support.width, settings.support.width});
        break;
    case TextonSettings::Shape::Rectangle:
        params.support = Support::rectangle(settings.support);
        break;
    case TextonSettings::Shape::Disc:
        params.support = Support::disc(settings.support.width);
        break;
    }
    params.interpolationOrder = settings.interpolationOrder;
    params.iterations = settings.iterations;
    params.momentum = settings.momentum;
    params.seed = settings.seed;
    params.colorCorrection = settings.colorCorrection;
    return params;
}

} // namespace txn::app
