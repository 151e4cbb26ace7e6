// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/display/PicturePyramid.h"
#include "app/document/Source.h"
#include "core/gaussian/Exemplar.h"
#include "core/gaussian/GaussianModel.h"
#include "core/mesh/TriangleMesh.h"
#include "core/qa/Suitability.h"
#include "core/qa/TextureAnalysis.h"
#include "core/texton/Texton.h"

#include <QImage>
#include <memory>
#include <vector>

namespace txn::app {

// Immutable, shared between the pipeline, views and jobs.

struct ExemplarResult {
    std::shared_ptr<const Source> source;
    Exemplar exemplar; ///< cropped, straightened, flattened
    GaussianModel model;
    PicturePyramid picture; ///< of exemplar.image
    QImage overview;        ///< of the whole picture that was opened, for the crop, up to 1024 px
    QImage evenBefore;      ///< the exemplar with and without its lighting evened, up to 384 px
    QImage evenAfter;
    QImage seamBefore; ///< where four repeated exemplars meet, 192 x 192 px or less
    QImage seamAfter;  ///< the same of the periodic component
};

struct GaussianResult {
    PicturePyramid picture;
};

struct ErrorPoint {
    int iteration = 0;
    double relativeModelError = 0.0;
};

/// A texton, finished or still on its way.
struct TextonResult {
    Texton texton; ///< colour corrected, where asked for
    PicturePyramid picture;
    std::vector<ErrorPoint> curve;
    int iteration = 0;
    int iterations = 0;
    double relativeModelError = 0.0;
    bool finished = false;
    bool imported = false; ///< came from a file: there is no curve and no error
};

/// Log power spectra, autocorrelations and histograms of exemplar, Gaussian version and noise.
struct AnalysisResult {
    TextureAnalysis exemplar;
    TextureAnalysis gaussian;
    TextureAnalysis noise;
};

} // namespace txn::app
