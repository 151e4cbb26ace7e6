// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectFile.h"

#include "app/document/ProjectReader.h"
#include "core/base/OutputFiles.h"
#include "core/mesh/BuiltinMeshes.h"

#include <QCborMap>
#include <QCborValue>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace txn::app {
namespace {

const QString kFormat = QStringLiteral("texton-studio-project");
constexpr int kVersion = 1;

struct Warnings {
    Q_DECLARE_TR_FUNCTIONS(Warnings)
};

std::string named(const QString& path) {
    return quoted(std::filesystem::path(QFile::encodeName(path).toStdString()));
}

QCborValue imageValue(const Image& image) {
    const auto samples = image.samples();
    QCborMap map;
    map[QStringLiteral("width")] = image.width();
    map[QStringLiteral("height")] = image.height();
    map[QStringLiteral("channels")] = image.channels();
    map[QStringLiteral("samples")] = QByteArray(reinterpret_cast<const char*>(samples.data()),
                                                static_cast<qsizetype>(samples.size_bytes()));
    return map;
}

QCborValue mapsValue(const MaterialMaps& maps) {
    QCborArray array;
    for (const MaterialMap& map : maps)
        array.append(QCborMap{{QStringLiteral("name"), QString::fromStdString(map.name)},
                              {QStringLiteral("kind"), static_cast<int>(map.kind)},
                              {QStringLiteral("channels"), map.channels}});
    return array;
}

QCborValue textonValue(const TextonAsset& asset) {
    const Texton& texton = asset.texton;
    const Size size = texton.support.size();
    QCborMap map;
    QCborArray kernels;
    for (const Image& kernel : texton.kernels)
        kernels.append(imageValue(kernel));
    QCborArray mean;
    for (const double m : texton.mean)
        mean.append(m);
    QByteArray inside(static_cast<qsizetype>(size.area()), '\0');
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            inside[static_cast<qsizetype>(y) * size.width + x] =
                texton.support.contains(x, y) ? 1 : 0;
    }
    map[QStringLiteral("kernels")] = kernels;
    map[QStringLiteral("mean")] = mean;
    map[QStringLiteral("shape")] = static_cast<int>(texton.support.shape());
    map[QStringLiteral("inside")] = inside;
    map[QStringLiteral("order")] = texton.interpolationOrder;
    map[QStringLiteral("linear")] = texton.transfer == Transfer::Linear;
    map[QStringLiteral("process")] = static_cast<int>(asset.process);
    map[QStringLiteral("mni")] = asset.meanImpacts;
    map[QStringLiteral("seed")] = static_cast<qint64>(asset.seed.value);
    map[QStringLiteral("exemplar")] = QString::fromStdString(asset.exemplarName);
    if (!asset.maps.empty())
        map[QStringLiteral("maps")] = mapsValue(asset.maps);
    return map;
}

/// From the folder to the file. Empty where there is no way but over the root: that would tell of
/// the machine what an absolute path does.
QString relativeLink(const QString& folder, const QString& file) {
    const QString link = QDir(folder).relativeFilePath(file);
    const auto depth = QDir::cleanPath(folder).split(QLatin1Char('/'), Qt::SkipEmptyParts).size();
    const bool overRoot = depth > 0 && link.startsWith(QStringLiteral("../").repeated(depth));
    return QDir::isAbsolutePath(link) || overRoot ? QString() : link;
}

QCborMap fileValue(const Source::File& file, ExemplarStorage storage, const QString& folder) {
    QCborMap map;
    map[QStringLiteral("name")] = file.name;
    if (!file.sample.isEmpty()) {
        map[QStringLiteral("sample")] = file.sample;
        return map;
    }
    map[QStringLiteral("sha256")] = file.hash;
    // Relative, so that folders can move and nothing is told of the machine.
    const QString link = relativeLink(folder, file.path);
    if (storage == ExemplarStorage::Linked && !file.path.isEmpty() && !link.isEmpty())
        map[QStringLiteral("link")] = link;
    else
        map[QStringLiteral("bytes")] = file.bytes;
    return map;
}

QCborValue sourceValue(const Source& source, ExemplarStorage storage, const QString& folder) {
    if (source.maps().empty())
        return fileValue(source.files().front(), storage, folder);
    QCborArray maps;
    for (const Source::File& file : source.files()) {
        QCborMap map = fileValue(file, storage, folder);
        map[QStringLiteral("map")] = file.map;
        map[QStringLiteral("kind")] = static_cast<int>(file.kind);
        maps.append(map);
    }
    return QCborMap{{QStringLiteral("maps"), maps}};
}

QCborValue editValue(const ExemplarEdit& edit) {
    QCborMap map;
    if (edit.crop)
        map[QStringLiteral("crop")] = QCborArray{static_cast<qint64>(edit.crop->x),
                                                 static_cast<qint64>(edit.crop->y),
                                                 edit.crop->size.width,
                                                 edit.crop->size.height};
    map[QStringLiteral("straighten")] = edit.straightenDegrees;
    if (edit.flattenRadiusPx)
        map[QStringLiteral("flatten")] = *edit.flattenRadiusPx;
    map[QStringLiteral("linear")] = edit.linear;
    map[QStringLiteral("periodic")] = edit.periodic;
    map[QStringLiteral("flip_green")] = edit.flipGreen;
    return map;
}

QCborValue gaussianValue(const GaussianSettings& gaussian) {
    return QCborMap{{QStringLiteral("method"), static_cast<int>(gaussian.method)},
                    {QStringLiteral("seed"), static_cast<qint64>(gaussian.seed.value)}};
}

QCborValue settingsValue(const TextonSettings& texton) {
    return QCborMap{{QStringLiteral("width"), texton.support.width},
                    {QStringLiteral("height"), texton.support.height},
                    {QStringLiteral("shape"), static_cast<int>(texton.shape)},
                    {QStringLiteral("order"), texton.interpolationOrder},
                    {QStringLiteral("method"), static_cast<int>(texton.method)},
                    {QStringLiteral("kernels"), texton.kernels},
                    {QStringLiteral("iterations"), texton.iterations},
                    {QStringLiteral("momentum"), texton.momentum},
                    {QStringLiteral("seed"), static_cast<qint64>(texton.seed.value)},
                    {QStringLiteral("seed_locked"), texton.seedLocked},
                    {QStringLiteral("color_correction"), texton.colorCorrection}};
}

QCborValue noiseValue(const NoiseSettings& noise, const QString& folder) {
    QCborMap map{{QStringLiteral("process"), static_cast<int>(noise.process)},
                 {QStringLiteral("mni"), noise.meanImpacts},
                 {QStringLiteral("seed"), static_cast<qint64>(noise.seed.value)},
                 {QStringLiteral("filter"), static_cast<int>(noise.filter)},
                 {QStringLiteral("scale"), noise.scale},
                 {QStringLiteral("contrast"), noise.contrast},
                 {QStringLiteral("brightness"), noise.brightness},
                 {QStringLiteral("scene"), static_cast<int>(noise.scene)},
                 {QStringLiteral("lighting"), noise.lighting},
                 {QStringLiteral("map"), noise.map},
                 {QStringLiteral("light_azimuth"), noise.light.azimuth},
                 {QStringLiteral("light_elevation"), noise.light.elevation}};
    const QString link = relativeLink(folder, noise.mesh);
    map[QStringLiteral("mesh")] = builtinMesh(noise.mesh.toStdString()) ? noise.mesh
                                  : link.isEmpty() ? QFileInfo(noise.mesh).fileName()
                                                   : link;
    return map;
}

/// What a mixture is made of beside the first exemplar.
QCborValue mixValue(const MixSettings& mix, ExemplarStorage storage, const QString& folder) {
    return QCborMap{{QStringLiteral("exemplar"), sourceValue(*mix.source, storage, folder)},
                    {QStringLiteral("edit"), editValue(mix.edit)},
                    {QStringLiteral("textons"), mix.textons},
                    {QStringLiteral("map_width"), mix.map.size().width},
                    {QStringLiteral("map_height"), mix.map.size().height},
                    {QStringLiteral("map"), mix.map.toBytes()},
                    {QStringLiteral("map_scale"), mix.mapScale},
                    {QStringLiteral("repeats"), mix.repeats}};
}

QCborValue viewValue(const ViewState& view) {
    QCborArray shown;
    for (const Picture picture : view.shown)
        shown.append(static_cast<int>(picture));
    QCborMap map{{QStringLiteral("layout"), static_cast<int>(view.layout)},
                 {QStringLiteral("shown"), shown},
                 {QStringLiteral("wipe"), view.wipe},
                 {QStringLiteral("x"), view.centerX},
                 {QStringLiteral("y"), view.centerY},
                 {QStringLiteral("zoom"), view.zoom},
                 {QStringLiteral("exposure"), view.exposure},
                 {QStringLiteral("tiled"), view.tiled},
                 {QStringLiteral("yaw"), view.yaw},
                 {QStringLiteral("pitch"), view.pitch},
                 {QStringLiteral("distance"), view.distance}};
    if (view.channel)
        map[QStringLiteral("channel")] = *view.channel;
    return map;
}

/// Where a link of a project leads.
QString linkedFile(const QString& folder, const QString& link) {
    return QDir::cleanPath(QDir(folder).absoluteFilePath(link));
}

/// Whether there is such a file, and outside the folder. Symbolic links count for what they point
/// to.
bool isOutside(const QString& folder, const QString& file) {
    const QString real = QFileInfo(file).canonicalFilePath();
    const QString home = QFileInfo(folder).canonicalFilePath();
    return !real.isEmpty() &&
           (home.isEmpty() ||
            !real.startsWith(home.endsWith(QLatin1Char('/')) ? home : home + QLatin1Char('/')));
}

/// All files outside the folder that a project would have opened.
QStringList filesOutside(const CborReader& root, const QString& folder) {
    QStringList links{root.map("noise").text("mesh")};
    for (const CborReader& source : {root.map("exemplar"), root.map("mix").map("exemplar")}) {
        links.append(source.text("link"));
        for (const auto& map : source.array("maps"))
            links.append(CborReader(map.toMap()).text("link"));
    }
    QStringList outside;
    for (const QString& link : links) {
        if (link.isEmpty() || QDir::isAbsolutePath(link)) // which nobody follows
            continue;
        if (const QString file = linkedFile(folder, link); isOutside(folder, file))
            outside.append(file);
    }
    outside.removeDuplicates();
    return outside;
}

/// Exemplars of a project in a folder.
struct SourceReader {
    const QString& folder;
    const LoadOptions& pictures;
    QStringList& warnings;

    Result<std::shared_ptr<const Source>> file(const CborReader& reader) const;
    Result<std::shared_ptr<const Source>> source(const CborReader& reader) const;
};

Result<std::shared_ptr<const Source>> SourceReader::file(const CborReader& reader) const {
    const QString name = reader.text("name");
    if (const QString sample = reader.text("sample"); !sample.isEmpty())
        return sampleSource(sample);
    if (const QByteArray bytes = reader.bytes("bytes"); !bytes.isEmpty())
        return decodeSource(bytes, name.isEmpty() ? QStringLiteral("exemplar") : name, pictures);
    const QString link = reader.text("link");
    if (link.isEmpty() || QDir::isAbsolutePath(link))
        return Error{ErrorCode::Unreadable, "the exemplar is missing"};
    auto source = openSource(linkedFile(folder, link), pictures);
    if (source && (*source)->hash() != reader.bytes("sha256"))
        warnings.append(
            Warnings::tr("%1 has changed since the project was saved.").arg((*source)->name()));
    return source;
}

Result<std::shared_ptr<const Source>> SourceReader::source(const CborReader& reader) const {
    const QCborArray maps = reader.array("maps");
    if (maps.isEmpty())
        return file(reader);
    if (maps.size() > kMaxExemplarChannels)
        return Error{ErrorCode::Unreadable, "damaged: there are too many maps"};
    std::vector<Source::Part> parts;
    for (const auto& value : maps) {
        CborReader map(value.toMap());
        auto source = file(map);
        if (!source)
            return source.error();
        const auto kind =
            static_cast<MapKind>(map.integer("kind", 0, static_cast<qint64>(MapKind::Data), 0));
        const QString name = map.text("map");
        if (!map.isGood() || !isMapName(name.toStdString()))
            return Error{ErrorCode::Unreadable, "a map of the material is damaged"};
        parts.push_back({std::move(*source), name, kind});
    }
    return stackSource(parts);
}

Result<void> readMix(CborReader reader, const SourceReader& sources, MixSettings& mix) {
    auto source = sources.source(reader.map("exemplar"));
    if (!source)
        return source.error();
    mix.source = std::move(*source);
    const Error damaged{ErrorCode::Unreadable, "damaged: the mixture is not whole"};
    if (!readEdit(reader.map("edit"), mix.edit) || !readMixSettings(reader, mix))
        return damaged;
    return {};
}

} // namespace

QByteArray encodeProject(const Project& project,
                         const ViewState& view,
                         ExemplarStorage storage,
                         const QString& projectFolder,
                         const QByteArray& thumbnail) {
    QCborMap map;
    map[QStringLiteral("format")] = kFormat;
    map[QStringLiteral("version")] = kVersion;
    if (!thumbnail.isEmpty())
        map[QStringLiteral("thumbnail")] = thumbnail;
    if (project.source)
        map[QStringLiteral("exemplar")] = sourceValue(*project.source, storage, projectFolder);
    if (project.importedTexton)
        map[QStringLiteral("texton")] = textonValue(*project.importedTexton);
    map[QStringLiteral("linked")] = project.linked;
    map[QStringLiteral("edit")] = editValue(project.edit);
    map[QStringLiteral("gaussian")] = gaussianValue(project.gaussian);
    map[QStringLiteral("settings")] = settingsValue(project.texton);
    map[QStringLiteral("noise")] = noiseValue(project.noise, projectFolder);
    if (project.mix.source)
        map[QStringLiteral("mix")] = mixValue(project.mix, storage, projectFolder);
    map[QStringLiteral("view")] = viewValue(view);
    return QCborValue(QCborKnownTags::Signature, map).toCbor();
}

Result<SavedProject>
decodeProject(const QByteArray& bytes, const QString& path, const Trust& trust) {
    const auto damaged = [&](const std::string& reason) {
        return Error{ErrorCode::Unreadable, named(path) + ": " + reason};
    };
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(bytes, &problem);
    if (problem.error != QCborError::NoError)
        return damaged("not a whole Texton Studio project; open another copy of it");
    CborReader root(value.taggedValue(value).toMap());
    if (root.text("format") != kFormat)
        return damaged("not a Texton Studio project");
    const auto version = root.integer("version", 1, 1 << 20, 0);
    if (version > kVersion)
        return damaged("made by a later version of Texton Studio; please update the program");

    SavedProject saved;
    const QString folder = QFileInfo(path).absolutePath();
    if (!trust.outside) {
        saved.outside = filesOutside(root, folder);
        if (!saved.outside.isEmpty())
            return saved;
    }
    const SourceReader sources{folder, trust.pictures, saved.warnings};
    if (root.has("exemplar")) {
        auto source = sources.source(root.map("exemplar"));
        if (!source)
            return Error{source.error().code, named(path) + ": " + source.error().message};
        saved.project.source = std::move(*source);
    } else if (root.has("texton")) {
        auto asset = readTextonAsset(root.map("texton"));
        if (!asset)
            return damaged(asset.error().message);
        saved.project.importedTexton = std::make_shared<const TextonAsset>(std::move(*asset));
    }
    if (saved.project.source && root.has("mix")) {
        if (const auto ok = readMix(root.map("mix"), sources, saved.project.mix); !ok)
            return Error{ok.error().code, named(path) + ": " + ok.error().message};
    }
    saved.project.linked = root.flag("linked", false);
    bool good = root.isGood();
    good = readEdit(root.map("edit"), saved.project.edit) && good;
    good = readGaussian(root.map("gaussian"), saved.project.gaussian) && good;
    good = readSettings(root.map("settings"), saved.project.texton) && good;
    good = readNoise(root.map("noise"), saved.project.noise) && good;
    good = readView(root.map("view"), saved.view) && good;
    if (!good)
        return damaged("damaged: a value is out of its range; open another copy of it");
    QString& mesh = saved.project.noise.mesh;
    if (!builtinMesh(mesh.toStdString())) {
        const QString file = QDir::isAbsolutePath(mesh) ? QString() : linkedFile(folder, mesh);
        const bool there = !file.isEmpty() && QFileInfo(file).isFile();
        if (!there)
            saved.warnings.append(
                Warnings::tr("%1 is missing; a sphere takes its place.").arg(mesh));
        mesh = there ? file : NoiseSettings{}.mesh;
    }
    return saved;
}

Result<void> writeWhole(const QString& path, const QByteArray& bytes) {
    OutputFiles files;
    if (auto added = files.addText(QFile::encodeName(path).toStdString(),
                                   {bytes.constData(), static_cast<std::size_t>(bytes.size())});
        !added)
        return added;
    return files.commit();
}

Result<void> saveProject(const Project& project,
                         const ViewState& view,
                         const QString& path,
                         const QByteArray& thumbnail) {
    const auto storage = project.linked ? ExemplarStorage::Linked : ExemplarStorage::Embedded;
    const QByteArray bytes =
        encodeProject(project, view, storage, QFileInfo(path).absolutePath(), thumbnail);
    if (auto written = writeWhole(path, bytes); !written)
        return Error{written.error().code,
                     written.error().message + "; please choose another place"};
    return {};
}

Result<SavedProject> openProject(const QString& path, const Trust& trust) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{file.exists() ? ErrorCode::Unreadable : ErrorCode::NotFound,
                     named(path) + " cannot be read: " + file.errorString().toStdString() +
                         "; please open another copy of it"};
    return decodeProject(file.readAll(), path, trust);
}

} // namespace txn::app
