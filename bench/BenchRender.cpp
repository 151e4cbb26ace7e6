// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing with OpenGL: the paper's method against ours at an MNI that is no further from Gaussian.
#include "bench/BenchRender.h"

#include "bench/Fidelity.h"
#include "bench/PaperNoise.h"
#include "core/gaussian/WhiteNoise.h"
#include "core/mesh/BuiltinMeshes.h"
#include "gl/NoiseRenderer.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace txn::bench {
namespace {

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// What all rows share.
struct Session {
    const Result<HeadlessContext>& context;
    FidelityTable fidelities;
    std::map<std::string, double> paperSeconds; ///< per frame, by "view/support:S/WxH"
};

enum class Scene { Plane, Perspective, Surface, Mesh };
constexpr std::array kPaperScenes{Scene::Plane, Scene::Perspective, Scene::Surface};

/// One row but for its method.
struct Frame {
    Scene scene = Scene::Plane;
    int support = 64;
    Size size;

    std::string name() const {
        constexpr std::array kNames{"plane", "perspective", "surface", "mesh"};
        return std::string(kNames.at(static_cast<std::size_t>(scene))) +
               "/support:" + std::to_string(support) + '/' + std::to_string(size.width) + 'x' +
               std::to_string(size.height);
    }
};

std::vector<Frame> frames(Scene scene) {
    constexpr std::array<Size, 4> kSizes{Size{512, 512},
                                         Size{1024, 1024},
                                         Size{1920, 1080},
                                         Size{3840, 2160}};
    std::vector<Frame> result;
    for (const int support : {64, 256}) {
        for (const Size size : kSizes)
            result.push_back({scene, support, size});
    }
    return result;
}

View viewOf(Scene scene) {
    if (scene == Scene::Plane)
        return PlaneView{};
    if (scene == Scene::Perspective) {
        GroundView ground;
        ground.camera.pitch = 0.26;
        return ground;
    }
    MeshView mesh;
    mesh.mapping = scene == Scene::Surface ? MeshView::Mapping::Surface
                                           : MeshView::Mapping::TextureCoordinates;
    return mesh;
}

/// Times do not depend on what the kernel shows.
Texton randomTexton(int side) {
    Texton texton;
    texton.support = Support::rectangle({side, side});
    texton.mean = {0.5, 0.4, 0.3};
    texton.kernels = {whiteNoise({side, side}, 3, Seed{1})};
    return texton;
}

using Draw = std::function<Result<void>(const OffscreenTarget&)>;

/// Times frames; the seconds that one took, or nothing where drawing fails.
std::optional<double>
timeFrames(benchmark::State& state, const HeadlessContext& context, Size size, const Draw& draw) {
    const auto target = OffscreenTarget::create(context.gl(), size);
    if (!target) {
        state.SkipWithError(target.error().message.c_str());
        return std::nullopt;
    }
    if (const auto drawn = draw(*target); !drawn) {
        state.SkipWithError(drawn.error().message.c_str());
        return std::nullopt;
    }
    context.finish();
    const double start = seconds();
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(draw(*target));
        context.finish();
    }
    const double perFrame = (seconds() - start) / static_cast<double>(state.iterations());
    state.counters["megapixels_per_s"] = static_cast<double>(size.area()) * 1e-6 / perFrame;
    return perFrame;
}

/// The authors' method; their figures for it are the plane's.
std::optional<double>
timePaper(benchmark::State& state, const HeadlessContext& context, const Frame& frame) {
    const Texton texton = randomTexton(frame.support);
    auto noise = PaperNoise::create(context.gl(), texton, Seed{1});
    auto checked = noise ? noise->check(context.gl(), texton) : Result<void>(noise.error());
    if (!checked) {
        state.SkipWithError(checked.error().message.c_str());
        return std::nullopt;
    }
    state.counters["mni"] = PaperNoise::kMeanImpacts;
    return timeFrames(state, context, frame.size, [&](const OffscreenTarget& target) {
        noise->draw(target);
        return Result<void>();
    });
}

std::optional<double> timeOurs(benchmark::State& state,
                               const HeadlessContext& context,
                               const Frame& frame,
                               const NoiseStyle& style) {
    NoiseRenderer renderer;
    renderer.setTexton(std::make_shared<const Texton>(randomTexton(frame.support)));
    renderer.setMesh(std::make_shared<const TriangleMesh>(torusMesh()));
    const View view = viewOf(frame.scene);
    state.counters["mni"] = style.noise.meanImpacts;
    return timeFrames(state, context, frame.size, [&](const OffscreenTarget& target) {
        return renderer.draw(context.gl(), view, style, target);
    });
}

constexpr int kMixedTextons = 21;

/// From A to B across the middle of the picture, as finely as it is painted.
MixingMap slope(Size size) {
    MixingMap map;
    map.rho = gradientMap(size, 30.0);
    map.placement = {-0.5 * size.width, -0.5 * size.height, 1.0 * size.width, 1.0 * size.height};
    return map;
}

/// Noise of one texton, or of several along a slope.
NoiseRenderer slopeRenderer(Size size, int textons) {
    const auto list = std::make_shared<const std::vector<Texton>>(static_cast<std::size_t>(textons),
                                                                  randomTexton(64));
    NoiseRenderer renderer;
    renderer.setTextons(list);
    renderer.setField(
        std::make_shared<const TextonField>(slope(size), textons, list->front().footprint()));
    renderer.setMesh(std::make_shared<const TriangleMesh>(torusMesh()));
    return renderer;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// A mixture against plain noise: frames of both by turns, so that whatever else the machine does
/// meets both alike; medians.
void timeMixed(benchmark::State& state,
               const HeadlessContext& context,
               Scene scene,
               const NoiseStyle& style) {
    constexpr Size kSize{512, 512};
    const auto target = OffscreenTarget::create(context.gl(), kSize);
    if (!target) {
        state.SkipWithError(target.error().message.c_str());
        return;
    }
    const View view = viewOf(scene);
    std::array renderers{slopeRenderer(kSize, 1), slopeRenderer(kSize, kMixedTextons)};
    std::array<std::vector<double>, 2> times;
    const auto draw = [&](std::size_t which) {
        const double start = seconds();
        auto drawn = renderers.at(which).draw(context.gl(), view, style, *target);
        context.finish();
        times.at(which).push_back(seconds() - start);
        return drawn;
    };
    for (const std::size_t which : {0U, 1U}) {
        if (const auto drawn = draw(which); !drawn) {
            state.SkipWithError(drawn.error().message.c_str());
            return;
        }
        times.at(which).clear();
    }
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(draw(0));
        benchmark::DoNotOptimize(draw(1));
    }
    const double plain = median(times[0]);
    const double mixed = median(times[1]);
    state.counters["plain_ms"] = 1e3 * plain;
    state.counters["mixed_ms"] = 1e3 * mixed;
    state.counters["times_plain"] = mixed / plain;
}

/// A stroke of the brush: a new map of 1024 x 1024, ready for drawing.
void timePainting(benchmark::State& state, const HeadlessContext& context) {
    constexpr Size kMap{1024, 1024};
    const auto list = std::make_shared<const std::vector<Texton>>(kMixedTextons, randomTexton(64));
    NoiseRenderer renderer;
    renderer.setTextons(list);
    const MixingMap map = slope(kMap);
    (void)timeFrames(state, context, {16, 16}, [&](const OffscreenTarget& target) {
        renderer.setField(
            std::make_shared<const TextonField>(map, kMixedTextons, list->front().footprint()));
        return renderer.draw(context.gl(), PlaneView{}, NoiseStyle{}, target);
    });
}

/// In space impacts count for less: twice as many make up for it ([TN17] section 9).
double meanImpactsFor(Scene scene, double ofPlane) {
    return scene == Scene::Surface ? 2.0 * ofPlane : ofPlane;
}

NoiseStyle paperStyle(Scene scene) {
    NoiseStyle style;
    style.noise.process = NoiseProcess::Poisson;
    style.noise.meanImpacts = meanImpactsFor(scene, PaperNoise::kMeanImpacts);
    return style;
}

void addRow(const std::string& name, const std::function<void(benchmark::State&)>& row) {
    benchmark::RegisterBenchmark(name.c_str(), row)->Unit(benchmark::kMillisecond)->UseRealTime();
}

/// Calls row(state, context) where there is one.
template <class Row>
auto withContext(const std::shared_ptr<Session>& session, Row row) {
    return [session, row](benchmark::State& state) {
        if (session->context)
            row(state, *session->context);
        else
            state.SkipWithError(session->context.error().message.c_str());
    };
}

/// plane: the paper's own shader. Elsewhere: our shaders with the paper's process.
void addPaper(const std::shared_ptr<Session>& session, const Frame& frame) {
    const bool ownShader = frame.scene == Scene::Plane;
    addRow((ownShader ? "paper/" : "paper_process/") + frame.name(),
           withContext(session, [=](benchmark::State& state, const HeadlessContext& context) {
               const auto time = ownShader
                                     ? timePaper(state, context, frame)
                                     : timeOurs(state, context, frame, paperStyle(frame.scene));
               if (time)
                   session->paperSeconds[frame.name()] = *time;
           }));
}

void addOurs(const std::shared_ptr<Session>& session,
             const std::string& prefix,
             const Frame& frame,
             PlaneMethod method) {
    addRow(prefix + frame.name(),
           withContext(session, [=](benchmark::State& state, const HeadlessContext& context) {
               NoiseStyle style;
               style.planeMethod = method;
               style.noise.meanImpacts =
                   meanImpactsFor(frame.scene, session->fidelities.meanImpacts());
               const auto time = timeOurs(state, context, frame, style);
               const auto paper = session->paperSeconds.find(frame.name());
               if (time && paper != session->paperSeconds.end())
                   state.counters["speedup"] = paper->second / *time;
           }));
}

void addMixed(const std::shared_ptr<Session>& session,
              const std::string& name,
              Scene scene,
              PlaneMethod method,
              Filter filter) {
    constexpr int kPairs = 31; // of frames
    benchmark::RegisterBenchmark(
        ("mixed/" + name).c_str(),
        withContext(session,
                    [=](benchmark::State& state, const HeadlessContext& context) {
                        NoiseStyle style;
                        style.planeMethod = method;
                        style.filter = filter;
                        style.noise.meanImpacts = meanImpactsFor(scene, style.noise.meanImpacts);
                        timeMixed(state, context, scene, style);
                    }))
        ->Iterations(kPairs)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

void addFidelity(const std::shared_ptr<Session>& session, const std::string& name) {
    benchmark::RegisterBenchmark(("fidelity/" + name).c_str(),
                                 [session, name](benchmark::State& state) {
                                     for ([[maybe_unused]] auto _ : state)
                                         benchmark::DoNotOptimize(session->fidelities.of(name));
                                     const Fidelity& found = session->fidelities.of(name);
                                     state.counters["kurtosis_limit"] = found.limit.kurtosis;
                                     state.counters["kurtosis_paper"] = found.paper.kurtosis;
                                     state.counters["kurtosis_ours"] = found.ours.kurtosis;
                                     state.counters["spread_limit"] = found.limit.spread;
                                     state.counters["spread_paper"] = found.paper.spread;
                                     state.counters["spread_ours"] = found.ours.spread;
                                     state.counters["mni_equal"] = found.meanImpacts;
                                 })
        ->Iterations(1)
        ->Unit(benchmark::kSecond)
        ->UseRealTime();
}

} // namespace

void registerRenderBenchmarks(const Result<HeadlessContext>& context) {
    const auto session = std::make_shared<Session>(Session{context, {}, {}});
    for (const std::string& name : session->fidelities.names())
        addFidelity(session, name);
    // The paper's rows of a kind come first: the others are compared with them.
    for (const Scene scene : kPaperScenes) {
        for (const Frame& frame : frames(scene))
            addPaper(session, frame);
        for (const Frame& frame : frames(scene))
            addOurs(session, "ours/", frame, PlaneMethod::Automatic);
    }
    for (const Frame& frame : frames(Scene::Plane))
        addOurs(session, "ours_per_pixel/", frame, PlaneMethod::PerPixel);
    for (const auto& [name, filter] :
         {std::pair{"none", Filter::None}, {"anisotropic", Filter::Anisotropic}}) {
        const std::string end = std::string("/") + name;
        addMixed(session, "plane" + end, Scene::Plane, PlaneMethod::Automatic, filter);
        addMixed(session, "per_pixel" + end, Scene::Plane, PlaneMethod::PerPixel, filter);
        addMixed(session, "perspective" + end, Scene::Perspective, PlaneMethod::Automatic, filter);
        addMixed(session, "mesh" + end, Scene::Mesh, PlaneMethod::Automatic, filter);
        addMixed(session, "surface" + end, Scene::Surface, PlaneMethod::Automatic, filter);
    }
    addRow("painting/1024x1024", withContext(session, timePainting));
}

} // namespace txn::bench
