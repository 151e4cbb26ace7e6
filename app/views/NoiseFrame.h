// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/display/PicturePyramid.h"
#include "core/material/MaterialMap.h"
#include "core/mesh/TriangleMesh.h"
#include "core/mixing/MixingMap.h"
#include "core/texton/Texton.h"
#include "gl/NoiseStyle.h"
#include "gl/View.h"

#include <QImage>
#include <memory>
#include <optional>
#include <vector>

namespace txn::app {

/// What a view wants to see of the noise. A plain value.
struct NoiseRequest {
    std::shared_ptr<const Texton> texton;
    std::shared_ptr<const std::vector<Texton>> mixture; ///< instead, where there is one, with
    std::shared_ptr<const MixingMap> mixingMap;         ///< where each of them is
    MaterialMaps maps;                                  ///< of a stack
    std::optional<std::size_t> map; ///< that is shown; unset: the material under the style's light
    std::shared_ptr<const TriangleMesh> mesh; ///< for mesh views
    NoiseStyle style;
    View view = PlaneView{};
    QSize size; ///< in device pixels
    DisplaySettings display;

    bool operator==(const NoiseRequest&) const = default;
};

/// What came of it.
struct NoiseFrame {
    QImage image;                         ///< of the request's size, or smaller while things move
    std::shared_ptr<const Image> samples; ///< what image was made of, y down, same size
    NoiseRequest request;                 ///< that it answers
    bool complete = false;                ///< full resolution; false: a first, coarse one
    bool onProcessor = false;             ///< without OpenGL
    double milliseconds = 0.0;            ///< that drawing took
    double fetchesPerPixel = 0.0;         ///< of the texton, on average
    double clippedShare = 0.0;            ///< of the samples outside [0, 1]
};

} // namespace txn::app
