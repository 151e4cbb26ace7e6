// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/NoiseOptions.h"
#include "cli/Parse.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "core/base/OutputFiles.h"
#include "core/export/Exporter.h"
#include "core/material/NormalMap.h"
#include "core/mesh/BuiltinMeshes.h"
#include "core/mesh/MeshIo.h"
#include "gl/HeadlessContext.h"
#include "gl/MaterialTextons.h"
#include "gl/MeshMap.h"
#include "gl/NoiseRenderer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

namespace txn::cli {
namespace {

struct Camera {
    double yaw = 0.0; ///< degrees
    double pitch = 0.0;
    double distance = 1.0;
    double fieldOfView = 45.0;
};

struct FilterChoice {
    Filter filter = Filter::Anisotropic;
    int supersampling = 1;
};

struct RenderArguments {
    std::filesystem::path texton;
    std::filesystem::path output;
    SaveOptions save;
    Size size{1024, 1024};
    std::string view = "plane";
    std::optional<std::string> mesh;
    double zoom = 1.0;
    std::optional<std::vector<double>> center;
    std::optional<double> rotation;
    std::optional<Camera> camera;
    std::string filterName = "anisotropic";
    FilterChoice filter;
    bool unlit = false;
    std::optional<std::string> map;
    std::optional<std::vector<double>> light;
    NoiseOptions noise;
    bool json = false;

    bool onMesh() const { return view == "mesh" || view == "surface"; }
};

std::optional<Camera> parseCamera(const std::string& text) {
    const auto values = parseNumbers(text, 2, 4);
    if (!values)
        return std::nullopt;
    Camera camera;
    camera.yaw = (*values)[0];
    camera.pitch = (*values)[1];
    if (values->size() > 2)
        camera.distance = (*values)[2];
    if (values->size() > 3)
        camera.fieldOfView = (*values)[3];
    return camera;
}

std::optional<FilterChoice> parseFilter(const std::string& text) {
    constexpr std::string_view kSupersample = "supersample:";
    if (text == "none")
        return FilterChoice{Filter::None};
    if (text == "mipmap")
        return FilterChoice{Filter::Mipmap};
    if (text == "anisotropic")
        return FilterChoice{Filter::Anisotropic};
    if (text == "hardware")
        return FilterChoice{Filter::Hardware};
    if (!text.starts_with(kSupersample))
        return std::nullopt;
    const auto side = parseNumbers(text.substr(kSupersample.size()), 1, 1);
    if (!side || side->front() < 1.0 || side->front() > NoiseStyle::kMaxSupersampling ||
        side->front() != std::floor(side->front()))
        return std::nullopt;
    return FilterChoice{Filter::None, static_cast<int>(side->front())};
}

/// Options that say nothing about the view asked for are mistakes.
Result<void> checkOptions(const RenderArguments& options) {
    const auto misplaced = [&](const std::string& name, const std::string& views) {
        return Error{ErrorCode::InvalidArgument,
                     name + " is for " + views + ", not for --view " + options.view};
    };
    if (options.center && options.onMesh())
        return misplaced("--center", "--view plane and perspective");
    if (options.rotation && options.view != "plane")
        return misplaced("--rotate", "--view plane (elsewhere, use --camera)");
    if (options.camera && options.view == "plane")
        return misplaced("--camera", "--view perspective, mesh and surface");
    if (options.mesh && !options.onMesh())
        return misplaced("--mesh", "--view mesh and surface");
    if (options.unlit && !options.onMesh())
        return misplaced("--unlit", "--view mesh and surface");
    return {};
}

OrbitCamera orbit(const Camera& camera) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    return {camera.yaw * kDegree,
            camera.pitch * kDegree,
            camera.distance,
            camera.fieldOfView * kDegree};
}

Result<View> makeView(const RenderArguments& options, NoiseRenderer& renderer) {
    const double x = options.center ? (*options.center)[0] : 0.0;
    const double y = options.center ? (*options.center)[1] : 0.0;
    // Low enough over the ground to see the horizon.
    const double pitch = options.view == "perspective" ? 15.0 : 20.0;
    const OrbitCamera camera = orbit(options.camera.value_or(Camera{0.0, pitch}));
    if (options.view == "plane")
        return View(PlaneView{x,
                              y,
                              options.zoom,
                              options.rotation.value_or(0.0) * std::numbers::pi / 180.0});
    if (options.view == "perspective")
        return View(GroundView{x, y, options.zoom, camera});

    const std::string name = options.mesh.value_or("sphere");
    auto mesh = std::make_shared<TriangleMesh>();
    if (auto builtin = builtinMesh(name)) {
        *mesh = std::move(*builtin);
    } else {
        auto loaded = loadMesh(name);
        if (!loaded)
            return loaded.error();
        *mesh = std::move(*loaded);
    }
    if (options.view == "mesh" && mesh->uvs.empty())
        return Error{ErrorCode::Unsupported,
                     quoted(std::filesystem::path(name)) +
                         " has no texture coordinates; --view surface does without them"};
    MeshView view;
    view.mapping =
        options.view == "mesh" ? MeshView::Mapping::TextureCoordinates : MeshView::Mapping::Surface;
    view.camera = camera;
    view.pixelsPerUnit =
        picturePixelsPerUnit(camera, boundingSphere(*mesh), options.size) / options.zoom;
    view.lighting = !options.unlit;
    renderer.setMesh(std::move(mesh));
    return View(view);
}

/// What is drawn of a texton.
struct Drawn {
    std::shared_ptr<const Texton> texton;
    std::shared_ptr<const Texton> relief; ///< of a shaded material
    int channels = 3;
    /// Of the picture, before it is written: normals are drawn as slopes.
    std::function<Image(const Image&)> finish = [](const Image& picture) { return picture; };
    std::string name;    ///< of the map, or "material"; empty for plain textons
    bool isData = false; ///< then no light falls on it, and nothing around it is a colour
};

Result<Drawn> whatToDraw(const RenderArguments& options, const TextonAsset& asset) {
    const Texton& texton = asset.texton;
    if (asset.maps.empty()) {
        if (options.map || options.light)
            return Error{ErrorCode::InvalidArgument,
                         std::string(options.map ? "--map" : "--light") +
                             " is for textons of stacks; " + quoted(options.texton) +
                             " is one of a picture"};
        const int channels = texton.channels() > 4 ? 3 : texton.channels();
        Drawn drawn;
        drawn.texton = std::make_shared<Texton>(firstChannels(texton, channels));
        drawn.channels = channels;
        return drawn;
    }
    const std::string name = options.map.value_or("material");
    if (name == "material") {
        auto material = materialTextons(texton, asset.maps);
        Drawn drawn;
        drawn.texton = std::move(material.base);
        drawn.relief = std::move(material.relief);
        drawn.name = name;
        return drawn;
    }
    const auto index = findMap(asset.maps, name);
    if (!index) {
        std::string names = "material";
        for (const MaterialMap& map : asset.maps)
            names += ", " + map.name;
        return Error{ErrorCode::InvalidArgument,
                     "there is no map '" + name + "' in " + quoted(options.texton) +
                         "; --map takes " + names};
    }
    const MapKind kind = asset.maps[*index].kind;
    Drawn drawn;
    drawn.texton = std::make_shared<Texton>(mapTexton(texton, asset.maps, *index));
    drawn.channels = drawn.texton->channels();
    drawn.name = name;
    drawn.isData = kind != MapKind::Color;
    if (isNormal(kind))
        drawn.finish = [yDown = kind == MapKind::NormalYDown](const Image& picture) {
            return normalsOfSlopes(picture, yDown);
        };
    return drawn;
}

/// Milliseconds per frame: the median of up to nine more within about two seconds. The first frame,
/// with all its preparations, counts only where it alone took longer than that.
Result<double>
frameTime(double first, const std::function<Result<void>()>& draw, const CancelToken& cancel) {
    if (first > 2000.0)
        return first;
    std::vector<double> times;
    double spent = 0.0;
    while (times.size() < 9 && (times.empty() || spent < 2000.0) && !cancel.cancelled()) {
        Stopwatch watch;
        if (auto ok = draw(); !ok)
            return ok.error();
        times.push_back(1000.0 * watch.lap());
        spent += times.back();
    }
    std::nth_element(times.begin(),
                     times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                     times.end());
    return times.empty() ? first : times[times.size() / 2];
}

Result<void> run(const RenderArguments& options, const CancelToken& cancel) {
    if (const auto ok = checkPictureOutput(options.texton, options.output); !ok)
        return ok.error();
    if (const auto ok = checkOptions(options); !ok)
        return ok.error();
    const auto asset = loadTexton(options.texton);
    if (!asset)
        return asset.error();
    for (const auto& input : textonFiles(options.texton, asset->maps)) {
        if (const auto ok = checkNotInput(input, options.output); !ok)
            return ok.error();
    }
    const auto context = HeadlessContext::create();
    if (!context)
        return context.error();

    NoiseStyle style;
    style.noise =
        options.noise.params({asset->process, asset->meanImpacts, asset->seed, std::nullopt});
    // Impulses of a surface weigh less the farther they are from it: it takes twice as many.
    if (options.view == "surface" && !options.noise.meanImpacts)
        style.noise.meanImpacts *= 2.0;
    style.filter = options.filter.filter;
    style.supersampling = options.filter.supersampling;

    const Texton& texton = asset->texton;
    const auto drawn = whatToDraw(options, *asset);
    if (!drawn)
        return drawn.error();
    if (options.light) {
        style.light.azimuth = (*options.light)[0] * std::numbers::pi / 180.0;
        style.light.elevation = (*options.light)[1] * std::numbers::pi / 180.0;
    }
    NoiseRenderer renderer;
    renderer.setTexton(drawn->texton);
    renderer.setRelief(drawn->relief);
    auto view = makeView(options, renderer);
    if (!view)
        return view.error();
    if (drawn->isData)
        showAsData(*view);
    const auto target = OffscreenTarget::create(context->gl(), options.size);
    if (!target)
        return target.error();
    const auto draw = [&]() -> Result<void> {
        auto done = renderer.draw(context->gl(), *view, style, *target);
        context->finish();
        return done;
    };
    Stopwatch watch;
    {
        const BusySign sign("Drawing");
        if (auto ok = draw(); !ok)
            return ok.error();
    }
    const double first = 1000.0 * watch.lap();
    const Image picture = drawn->finish(target->read(drawn->channels, texton.transfer));
    if (cancel.cancelled())
        return Error{ErrorCode::Cancelled, "stopped"};
    if (auto ok = saveImage(picture, options.output, options.save); !ok)
        return ok.error();
    if (!options.json) {
        if (drawn->name.empty() && drawn->channels < texton.channels())
            std::cout << "drawn are the first " << drawn->channels << " of " << texton.channels()
                      << " channels\n";
        printWritten({&options.output, 1});
        return {};
    }
    const auto milliseconds = frameTime(first, draw, cancel);
    if (!milliseconds)
        return milliseconds.error();
    nlohmann::ordered_json json;
    json["width"] = options.size.width;
    json["height"] = options.size.height;
    json["channels"] = picture.channels();
    if (!drawn->name.empty())
        json["map"] = drawn->name;
    json["texton_channels"] = texton.channels();
    json["view"] = options.view;
    json["filter"] = options.filterName;
    json["mni"] = style.noise.meanImpacts;
    json["process"] = toString(style.noise.process);
    json["seed"] = style.noise.seed.value;
    json["renderer"] = context->gl().renderer();
    json["opengl"] = context->gl().version();
    json["milliseconds"] = *milliseconds;
    json["outputs"] = {options.output.string()};
    printJson(json);
    return {};
}

} // namespace

void addRender(CLI::App& app, Session& session) {
    auto* command =
        app.add_subcommand("render",
                           "Draw texton noise with OpenGL: flat, in perspective, on meshes");
    command->footer("Examples:\n"
                    "  texton render wood.exr -o ground.png --size 1920x1080 --view perspective\n"
                    "  texton render wood.exr -o teapot.png --view surface --mesh teapot.obj");
    auto options = std::make_shared<RenderArguments>();
    command->add_option("TEXTON", options->texton, "Texton: .exr, .png or .texton")->required();
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    addParsed(*command,
              "--size",
              options->size,
              parseWidthByHeight,
              "WxH",
              "Size in pixels (default: 1024x1024)");
    command
        ->add_option("--view",
                     options->view,
                     "plane: from above; perspective: a ground to the horizon; mesh: by a mesh's "
                     "texture coordinates; surface: on a mesh without them")
        ->check(CLI::IsMember({"plane", "perspective", "mesh", "surface"}))
        ->capture_default_str();
    command
        ->add_option("--mesh", options->mesh, "sphere, torus, plane, or a file (default: sphere)")
        ->type_name("FILE");
    command
        ->add_option("--zoom",
                     options->zoom,
                     "Pixels of the picture per exemplar pixel; in the middle of what is seen")
        ->type_name("Z")
        ->check(between(PlaneView::kMinZoom, PlaneView::kMaxZoom))
        ->capture_default_str();
    addParsed(
        *command,
        "--center",
        options->center,
        [](const std::string& text) -> std::optional<std::optional<std::vector<double>>> {
            if (auto point = parseNumbers(text, 2, 2))
                return point;
            return std::nullopt;
        },
        "X,Y",
        "What the middle shows, in exemplar pixels (default: 0,0)");
    command->add_option("--rotate", options->rotation, "Turn the plane clockwise, in degrees")
        ->type_name("DEG")
        ->check(between(-36000.0, 36000.0));
    addParsed(
        *command,
        "--camera",
        options->camera,
        [](const std::string& text) -> std::optional<std::optional<Camera>> {
            if (auto camera = parseCamera(text))
                return camera;
            return std::nullopt;
        },
        "YAW,PITCH[,DISTANCE[,FOV]]",
        "From where it is seen: two angles in degrees; a distance, 1 for the usual; and the angle "
        "of view (default: 0,20,1,45; for perspective 0,15)");
    command
        ->add_option_function<std::string>(
            "--filter",
            [options](const std::string& text) {
                const auto filter = parseFilter(text);
                if (!filter)
                    throw CLI::ValidationError("--filter",
                                               "'" + text +
                                                   "' is not none, mipmap, anisotropic, hardware "
                                                   "or supersample:N with N from 1 to 64");
                options->filter = *filter;
                options->filterName = text;
            },
            "How flicker is kept away: none, mipmap, anisotropic (default), hardware (the "
            "driver's own), or supersample:N (N x N points a pixel, slow and exact)")
        ->type_name("FILTER");
    command->add_flag("--unlit", options->unlit, "Meshes without light and shade");
    command
        ->add_option("--map",
                     options->map,
                     "Of a stack: material (all maps under a light) or the name of one map "
                     "(default: material)")
        ->type_name("NAME");
    addParsed(
        *command,
        "--light",
        options->light,
        [](const std::string& text) -> std::optional<std::optional<std::vector<double>>> {
            auto angles = parseNumbers(text, 2, 2);
            if (!angles || (*angles)[1] < 0.0 || (*angles)[1] > 90.0)
                return std::nullopt;
            return angles;
        },
        "AZIMUTH,ELEVATION",
        "Where the light of a material comes from, in degrees: from the right is 0,0, from the eye "
        "0,90 (default: 135,45)");
    addNoiseOptions(*command, options->noise, "--seed", "; twice that for --view surface");
    addDepth(*command, options->save);
    command->add_flag("--json",
                      options->json,
                      "Print a JSON object instead of text, with the time a frame takes");
    command->callback([options, &session] {
        session.run = [options, &session] { return run(*options, session.cancel); };
    });
}

} // namespace txn::cli
