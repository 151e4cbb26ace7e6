// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectReader.h"

#include "core/compute/MixSolver.h"
#include "core/noise/NoiseGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace txn::app {
namespace {

constexpr qint64 kMaxSeed = 0xffffffff;
constexpr int kMaxTextonSide = 8192;
constexpr int kMaxKernels = 64;

/// QCborValue::toInteger() converts doubles that no integer can hold, which is undefined.
qint64 integerOr(const QCborValue& value, qint64 other) {
    return value.isInteger() ? value.toInteger() : other;
}

Seed readSeed(CborReader& reader, const char* key, Seed standard) {
    return Seed{static_cast<std::uint32_t>(reader.integer(key, 0, kMaxSeed, standard.value))};
}

template <class Choice>
Choice choice(CborReader& reader, const char* key, Choice last, Choice standard) {
    return static_cast<Choice>(
        reader.integer(key, 0, static_cast<qint64>(last), static_cast<qint64>(standard)));
}

int order(CborReader& reader, int standard) {
    const auto value = static_cast<int>(reader.integer("order", 0, 5, standard));
    if (value == 2 || value == 4)
        reader.fail();
    return value;
}

Result<Image> readImage(CborReader reader, Transfer transfer) {
    const Error damaged{ErrorCode::Unreadable, "damaged: the texton is not whole"};
    const auto width = static_cast<int>(reader.integer("width", 1, kMaxTextonSide, 0));
    const auto height = static_cast<int>(reader.integer("height", 1, kMaxTextonSide, 0));
    const auto channels = static_cast<int>(reader.integer("channels", 1, kMaxExemplarChannels, 0));
    const QByteArray bytes = reader.bytes("samples");
    if (!reader.isGood() || width < 1 || height < 1 || channels < 1 ||
        bytes.size() != static_cast<qsizetype>(sizeof(float)) * width * height * channels)
        return damaged;
    Image image({width, height}, channels, 0.0F, transfer);
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(image.samples().data()));
    for (const float v : image.samples()) {
        if (!(std::abs(v) <= Exemplar::kLargestSample))
            return damaged;
    }
    return image;
}

} // namespace

qint64 CborReader::integer(const char* key, qint64 low, qint64 high, qint64 standard) {
    const QCborValue value = m_map.value(QLatin1String(key));
    if (value.isUndefined())
        return standard;
    const qint64 number = integerOr(value, low);
    if (value.isInteger() && number >= low && number <= high)
        return number;
    m_good = false;
    return standard;
}

double CborReader::number(const char* key, double low, double high, double standard) {
    const QCborValue value = m_map.value(QLatin1String(key));
    if (value.isUndefined())
        return standard;
    const double number = value.toDouble(std::nan(""));
    if ((value.isDouble() || value.isInteger()) && number >= low && number <= high)
        return number;
    m_good = false;
    return standard;
}

bool CborReader::flag(const char* key, bool standard) {
    const QCborValue value = m_map.value(QLatin1String(key));
    m_good = m_good && (value.isUndefined() || value.isBool());
    return value.toBool(standard);
}

bool readEdit(CborReader reader, ExemplarEdit& edit) {
    constexpr int kMaxSide = 1 << 24;
    if (reader.has("crop")) {
        std::array<qint64, 4> values{};
        const QCborArray crop = reader.array("crop");
        bool good = crop.size() == 4;
        for (qsizetype i = 0; good && i < 4; ++i) {
            values[static_cast<std::size_t>(i)] = integerOr(crop.at(i), -1);
            good = values[static_cast<std::size_t>(i)] >= (i < 2 ? 0 : 1) &&
                   values[static_cast<std::size_t>(i)] <= kMaxSide;
        }
        if (!good)
            return false;
        edit.crop =
            Rect{values[0], values[1], {static_cast<int>(values[2]), static_cast<int>(values[3])}};
    }
    edit.straightenDegrees = reader.number("straighten", -180.0, 180.0, 0.0);
    if (reader.has("flatten"))
        edit.flattenRadiusPx = reader.number("flatten", 0.5, 1e5, 80.0);
    edit.linear = reader.flag("linear", edit.linear);
    edit.periodic = reader.flag("periodic", edit.periodic);
    edit.flipGreen = reader.flag("flip_green", edit.flipGreen);
    return reader.isGood();
}

bool readGaussian(CborReader reader, GaussianSettings& gaussian) {
    gaussian.method = choice(reader, "method", GaussianMethod::RandomPhase, gaussian.method);
    gaussian.seed = readSeed(reader, "seed", gaussian.seed);
    return reader.isGood();
}

bool readSettings(CborReader reader, TextonSettings& texton) {
    const auto side = [&](const char* key, int standard) {
        return static_cast<int>(
            reader.integer(key, TextonSettings::kMinSidePx, TextonSettings::kMaxSidePx, standard));
    };
    texton.support = {side("width", texton.support.width), side("height", texton.support.height)};
    texton.shape = static_cast<TextonSettings::Shape>(
        reader.integer("shape", 0, 2, static_cast<int>(texton.shape)));
    texton.interpolationOrder = order(reader, texton.interpolationOrder);
    // Projects without it are older than the fit.
    texton.method = choice(reader, "method", TextonMethod::Projections, TextonMethod::Projections);
    texton.kernels = static_cast<int>(
        reader.integer("kernels", 0, TextonSettings::kMostKernels, texton.kernels));
    texton.iterations =
        static_cast<int>(reader.integer("iterations", 1, 100000, texton.iterations));
    texton.momentum = reader.number("momentum", 0.0, 0.999, texton.momentum);
    texton.seed = readSeed(reader, "seed", texton.seed);
    texton.seedLocked = reader.flag("seed_locked", texton.seedLocked);
    texton.colorCorrection = reader.flag("color_correction", texton.colorCorrection);
    return reader.isGood();
}

bool readNoise(CborReader reader, NoiseSettings& noise) {
    noise.process = choice(reader, "process", NoiseProcess::Poisson, noise.process);
    noise.meanImpacts = reader.number("mni",
                                      NoiseParams::kMinMeanImpacts,
                                      NoiseParams::kMaxMeanImpacts,
                                      noise.meanImpacts);
    noise.seed = readSeed(reader, "seed", noise.seed);
    noise.filter = choice(reader, "filter", Filter::Hardware, noise.filter);
    noise.scale = reader.number("scale", NoiseGrid::kMinScale, NoiseGrid::kMaxScale, noise.scale);
    noise.contrast = reader.number("contrast", 0.0, 10.0, noise.contrast);
    noise.brightness = reader.number("brightness", -10.0, 10.0, noise.brightness);
    noise.scene = choice(reader, "scene", NoiseScene::Surface, noise.scene);
    noise.lighting = reader.flag("lighting", noise.lighting);
    if (const QString mesh = reader.text("mesh"); !mesh.isEmpty())
        noise.mesh = mesh;
    noise.map = reader.text("map");
    noise.light.azimuth = reader.number("light_azimuth", -7.0, 7.0, noise.light.azimuth);
    noise.light.elevation = reader.number("light_elevation", 0.0, 1.6, noise.light.elevation);
    return reader.isGood();
}

bool readMixSettings(CborReader& reader, MixSettings& mix) {
    mix.textons = static_cast<int>(
        reader.integer("textons", MixSolver::kMinTextons, MixSolver::kMaxTextons, mix.textons));
    mix.mapScale = reader.number("map_scale", 1.0 / 64.0, 64.0, mix.mapScale);
    mix.repeats = reader.flag("repeats", mix.repeats);
    const auto width =
        static_cast<int>(reader.integer("map_width", 1, MixSettings::kMaxMapSide, 0));
    const auto height =
        static_cast<int>(reader.integer("map_height", 1, MixSettings::kMaxMapSide, 0));
    if (!reader.isGood() || width < 1 || height < 1)
        return false;
    auto map = PaintedMap::fromBytes(reader.bytes("map"), {width, height});
    if (!map)
        return false;
    mix.map = std::move(*map);
    return true;
}

bool readView(CborReader reader, ViewState& view) {
    constexpr double kFarthest = NoiseParams::kFarthest / 4.0;
    view.layout = choice(reader, "layout", ViewLayout::Wipe, view.layout);
    if (const QCborArray shown = reader.array("shown"); shown.size() == 4) {
        for (qsizetype i = 0; i < 4; ++i) {
            const qint64 picture = integerOr(shown.at(i), -1);
            if (picture < 0 || picture > static_cast<qint64>(Picture::Noise))
                return false;
            view.shown[static_cast<std::size_t>(i)] = static_cast<Picture>(picture);
        }
    }
    view.wipe = reader.number("wipe", 0.0, 1.0, view.wipe);
    view.centerX = reader.number("x", -kFarthest, kFarthest, view.centerX);
    view.centerY = reader.number("y", -kFarthest, kFarthest, view.centerY);
    view.zoom = reader.number("zoom", ViewState::kMinZoom, ViewState::kMaxZoom, view.zoom);
    view.exposure = reader.number("exposure", -10.0, 10.0, view.exposure);
    view.tiled = reader.flag("tiled", view.tiled);
    view.yaw = reader.number("yaw", -7.0, 7.0, view.yaw);
    view.pitch = reader.number("pitch", -1.6, 1.6, view.pitch);
    view.distance = reader.number("distance", 0.01, 100.0, view.distance);
    if (reader.has("channel"))
        view.channel = static_cast<int>(reader.integer("channel", 0, kMaxExemplarChannels - 1, 0));
    return reader.isGood();
}

Result<TextonAsset> readTextonAsset(CborReader reader) {
    const Error damaged{ErrorCode::Unreadable, "damaged: the texton is not whole"};
    TextonAsset asset;
    Texton& texton = asset.texton;
    texton.interpolationOrder = order(reader, texton.interpolationOrder);
    texton.transfer = reader.flag("linear", false) ? Transfer::Linear : Transfer::Encoded;
    const QCborArray kernels = reader.array("kernels");
    if (kernels.isEmpty() || kernels.size() > kMaxKernels)
        return damaged;
    for (const auto& kernel : kernels) {
        auto image = readImage(CborReader(kernel.toMap()), texton.transfer);
        if (!image)
            return image.error();
        if (!texton.kernels.empty() && (image->size() != texton.kernels.front().size() ||
                                        image->channels() != texton.kernels.front().channels()))
            return damaged;
        texton.kernels.push_back(std::move(*image));
    }
    const QCborArray means = reader.array("mean");
    for (const auto& mean : means) {
        const double value = mean.toDouble(std::nan(""));
        if (!(std::abs(value) <= static_cast<double>(Exemplar::kLargestSample)))
            return damaged;
        texton.mean.push_back(value);
    }
    const Size size = texton.kernels.front().size();
    if (texton.channels() != texton.kernels.front().channels())
        return damaged;
    const auto shape = choice(reader, "shape", SupportShape::Mask, SupportShape::Rectangle);
    const QByteArray inside = reader.bytes("inside");
    texton.support = Support::rectangle(size);
    if (shape == SupportShape::Disc && size.width == size.height) {
        texton.support = Support::disc(size.width);
    } else if (shape != SupportShape::Rectangle) {
        auto mask = Support::mask(size, std::vector<std::uint8_t>(inside.begin(), inside.end()));
        if (!mask)
            return damaged;
        texton.support = std::move(*mask);
    }
    asset.process = choice(reader, "process", NoiseProcess::Poisson, asset.process);
    asset.meanImpacts = reader.number("mni",
                                      NoiseParams::kMinMeanImpacts,
                                      NoiseParams::kMaxMeanImpacts,
                                      asset.meanImpacts);
    asset.seed = readSeed(reader, "seed", asset.seed);
    asset.exemplarName = reader.text("exemplar").toStdString();
    for (const auto& value : reader.array("maps")) {
        CborReader map(value.toMap());
        asset.maps.push_back(
            {map.text("name").toStdString(),
             static_cast<MapKind>(map.integer("kind", 0, static_cast<qint64>(MapKind::Data), 0)),
             static_cast<int>(map.integer("channels", 1, kMaxExemplarChannels, 1))});
        if (!map.isGood())
            return damaged;
    }
    if (!reader.isGood() || (!asset.maps.empty() && !areMapsOf(asset.maps, texton.channels())))
        return damaged;
    return asset;
}

} // namespace txn::app
