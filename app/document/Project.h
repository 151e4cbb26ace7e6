// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/PaintedMap.h"
#include "app/document/Source.h"
#include "core/compute/ComputeTexton.h"
#include "core/gaussian/GaussianSampler.h"
#include "core/mixing/MixingMap.h"
#include "gl/NoiseStyle.h"

#include <array>
#include <optional>

namespace txn::app {

/// How the picture that was opened becomes the exemplar, in this order.
struct ExemplarEdit {
    std::optional<Rect> crop;              ///< in pixels of the picture; unset: all of it
    double straightenDegrees = 0.0;        ///< counterclockwise
    std::optional<double> flattenRadiusPx; ///< unset: the lighting stays
    bool linear = false;                   ///< compute in linear light
    bool periodic = true;                  ///< take the periodic component
    bool flipGreen = false;                ///< normals whose green points the other way than told

    bool operator==(const ExemplarEdit&) const = default;
};

struct GaussianSettings {
    GaussianMethod method = GaussianMethod::Adsn;
    Seed seed;

    bool operator==(const GaussianSettings&) const = default;
};

struct TextonSettings {
    static constexpr int kMinSidePx = 4;
    static constexpr int kMaxSidePx = 1024;
    static constexpr int kAutomatic = 0; ///< number of kernels: by a trial
    static constexpr int kMostKernels = 16;

    enum class Shape { Square, Rectangle, Disc };

    Shape shape = Shape::Square;
    Size support{64, 64}; ///< squares and discs are as high as wide
    int interpolationOrder = 1;
    TextonMethod method = TextonMethod::Fit;
    int kernels = kAutomatic; ///< of a fit
    int iterations = 50;      ///< of projections, as is momentum
    double momentum = 0.9;
    Seed seed;
    bool seedLocked = false; ///< the dice leaves it alone
    bool colorCorrection = true;

    bool operator==(const TextonSettings&) const = default;
};

enum class NoiseScene { Plane, Perspective, Mesh, Surface };

struct NoiseSettings {
    NoiseProcess process = NoiseProcess::Stratified;
    double meanImpacts = defaultMeanImpacts(NoiseProcess::Stratified);
    Seed seed;
    Filter filter = Filter::Anisotropic;
    double scale = 1.0;      ///< pixels of noise per exemplar pixel
    double contrast = 1.0;   ///< factor on the deviation from the mean
    double brightness = 0.0; ///< added to the mean, in sample values

    NoiseScene scene = NoiseScene::Plane;
    QString mesh = QStringLiteral("sphere"); ///< "plane", "sphere", "torus" or a file's path
    bool lighting = true;

    QString map; ///< of a stack: the name of the one that is shown; empty: the shaded material
    Light light; ///< of the material

    bool operator==(const NoiseSettings&) const = default;
};

/// The second exemplar, B, and where the noise is made of which: A is the project's own.
struct MixSettings {
    static constexpr int kStandardTextons = 21;
    static constexpr int kMaxMapSide = 4096; ///< texels

    std::shared_ptr<const Source> source; ///< null: nothing is mixed
    ExemplarEdit edit;
    int textons = kStandardTextons; ///< on the way from A to B
    PaintedMap map;                 ///< 0: A, 1: B
    double mapScale = 1.0;          ///< exemplar pixels per texel of the map
    bool repeats = false;           ///< the map, beyond its border

    bool operator==(const MixSettings&) const = default;
};

/// A mixture needs impacts of both signs.
[[nodiscard]] NoiseProcess mixedProcess(NoiseProcess process);

/// The map lies around the middle of the plane.
[[nodiscard]] MapPlacement mapPlacement(const MixSettings& mix);

/// Everything that the artist decides and can undo. A plain value, cheap to copy: what is large is
/// shared. Either a picture is open (source), or a texton (importedTexton), or neither.
struct Project {
    std::shared_ptr<const Source> source;
    std::shared_ptr<const TextonAsset> importedTexton;
    bool linked = false; ///< project files tell where the picture is instead of holding it
    ExemplarEdit edit;
    GaussianSettings gaussian;
    TextonSettings texton;
    NoiseSettings noise;
    MixSettings mix;

    bool operator==(const Project&) const = default;
};

/// Of what is open; empty for plain pictures and textons of such.
[[nodiscard]] MaterialMaps mapsOf(const Project& project);

/// What core computes it by.
[[nodiscard]] ComputeParams computeParams(const TextonSettings& settings);

enum class Picture { Exemplar, Gaussian, Texton, Noise };
inline constexpr std::array<Picture, 4> kPictures{
    Picture::Exemplar, Picture::Gaussian, Picture::Texton, Picture::Noise};

enum class ViewLayout { Single, SideBySide, Quad, Wipe };

/// Where the artist looks and how. Comes back with the project, but is not undone.
struct ViewState {
    static constexpr double kMinZoom = 1.0 / 64.0;
    static constexpr double kMaxZoom = 64.0;

    ViewLayout layout = ViewLayout::Quad;
    std::array<Picture, 4> shown = kPictures; ///< by place: the first one, two or four are seen
    double wipe = 0.5;                        ///< where the border of the wipe is, 0 to 1

    double centerX = 0.0; ///< what the middle shows, in pixels from the exemplar's middle
    double centerY = 0.0;
    double zoom = 1.0; ///< device pixels per exemplar pixel

    double exposure = 0.0;        ///< in stops
    std::optional<int> channel;   ///< unset: all
    bool tiled = false;           ///< the exemplar is repeated
    bool keptBeside = false;      ///< the first view shows the kept texton and its noise
    std::optional<double> mixRho; ///< of a mixture: the texton there alone is shown; unset: all
    bool mapShown = false;        ///< the mixing map lies over the noise

    double yaw = 0.5; ///< of perspective and meshes; see OrbitCamera
    double pitch = 0.45;
    double distance = 1.0;

    bool operator==(const ViewState&) const = default;
};

} // namespace txn::app
