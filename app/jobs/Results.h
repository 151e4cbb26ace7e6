// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/display/PicturePyramid.h"
#include "app/document/Source.h"
#include "core/compute/MixSolver.h"
#include "core/gaussian/Exemplar.h"
#include "core/gaussian/GaussianModel.h"
#include "core/mesh/TriangleMesh.h"
#include "core/qa/CovarianceError.h"
#include "core/qa/Suitability.h"
#include "core/qa/SupportSuggestion.h"
#include "core/qa/TextureAnalysis.h"
#include "core/texton/Texton.h"

#include <QImage>
#include <memory>
#include <optional>
#include <vector>

namespace txn::app {

// Immutable, shared between the pipeline, views and jobs.

/// One picture, or one of each map of a stack.
using MapPictures = std::vector<PicturePyramid>;
[[nodiscard]] MapPictures mapPictures(const Image& image, const MaterialMaps& maps);

struct ExemplarResult {
    std::shared_ptr<const Source> source;
    Exemplar exemplar; ///< cropped, straightened, flattened
    GaussianModel model;
    MapPictures pictures; ///< of exemplar.image
    QImage overview;      ///< of the whole picture that was opened, for the crop, up to 1024 px
    QImage evenBefore;    ///< the exemplar with and without its lighting evened, up to 384 px
    QImage evenAfter;
    QImage seamBefore; ///< where four repeated exemplars meet, 192 x 192 px or less
    QImage seamAfter;  ///< the same of the periodic component
};

struct GaussianResult {
    MapPictures pictures;
};

/// What can be expected of an exemplar.
struct Judgement {
    std::optional<Suitability> suitability; ///< unset: it cannot be told (a flat colour, say)
    std::optional<SupportSuggestion> support;
};

struct ErrorPoint {
    int iteration = 0;
    double error = 0.0; ///< see TextonProgress
};

/// A texton, finished or still on its way.
struct TextonResult {
    Texton texton; ///< colour corrected, where asked for
    MaterialMaps maps;
    MapPictures pictures;
    std::vector<ErrorPoint> curve; ///< of the method's own error
    int iteration = 0;
    int iterations = 0;
    TextonMethod method = TextonMethod::Fit;
    double error = 0.0;                       ///< of the method, before colour correction
    std::optional<double> relativeModelError; ///< of projections, colour corrected
    std::optional<CovarianceError> dial;      ///< when finished; unset for tiny exemplars
    std::vector<double> trialErrors;          ///< see KernelChoice
    bool choosingKernels = false;             ///< a texton of a trial
    bool finished = false;
    bool imported = false; ///< came from a file: there is no curve and no error
};

/// One of the textons between two exemplars, as the film strip shows it.
struct MixFrame {
    double rho = 0.0;
    MapPictures pictures; ///< of the texton
    QImage texton;
    QImage noise; ///< of it alone, at 100 %
};

/// The textons between two exemplars, all of them or those so far.
struct MixResult {
    MixedTextons mixed;
    MaterialMaps maps;
    std::vector<MixFrame> frames; ///< one for each of mixed.textons
    double distance = 0.0;        ///< d_OT from A to B
    bool finished = false;
};

/// Log power spectra, autocorrelations and histograms of exemplar, Gaussian version and noise.
struct AnalysisResult {
    TextureAnalysis exemplar;
    TextureAnalysis gaussian;
    TextureAnalysis noise;
};

} // namespace txn::app
