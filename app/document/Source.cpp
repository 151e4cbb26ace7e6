// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Source.h"

#include "core/export/Exporter.h"
#include "core/material/MapStack.h"
#include "core/samples/Samples.h"

#include "app/threads/Background.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace txn::app {
namespace {

constexpr Size kSampleSize{512, 512};

std::filesystem::path toPath(const QString& name) {
    return {QFile::encodeName(name).toStdString()};
}

Result<Source::File> readFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{ErrorCode::Unreadable,
                     quoted(toPath(path)) + ": " + file.errorString().toStdString()};
    const QByteArray bytes = file.readAll();
    return Source::File{QFileInfo(path).fileName(),
                        QFileInfo(path).absoluteFilePath(),
                        {},
                        bytes,
                        QCryptographicHash::hash(bytes, QCryptographicHash::Sha256)};
}

Result<LoadedImage>
decoded(const QByteArray& bytes, const QString& name, const LoadOptions& options) {
    const auto size = static_cast<std::size_t>(bytes.size());
    return loadImage({reinterpret_cast<const std::uint8_t*>(bytes.constData()), size},
                     toPath(name),
                     options);
}

Result<LoadedImage> drawnSample(const QString& sample) {
    auto image = makeSample(sample.toStdString(), kSampleSize, Seed{1});
    if (!image)
        return image.error();
    LoadedImage loaded;
    loaded.image = std::move(*image);
    loaded.channelNames = {"R", "G", "B"};
    return loaded;
}

/// Of a file that was decoded before, however large.
Result<LoadedImage> decodedFile(const Source::File& file) {
    return file.sample.isEmpty() ? decoded(file.bytes, file.name, LoadOptions::insisted())
                                 : drawnSample(file.sample);
}

/// loaded: of the files, one each.
Result<MapStack> stackOf(const std::vector<Source::File>& files, std::vector<Image> images) {
    std::vector<MapPicture> pictures;
    for (std::size_t i = 0; i < files.size(); ++i)
        pictures.push_back({files[i].map.toStdString(),
                            files[i].kind,
                            std::move(images[i]),
                            files[i].name.toStdString()});
    return stackMaps(std::move(pictures));
}

Result<LoadedImage> decodedStack(const std::vector<Source::File>& files) {
    std::vector<Image> images;
    std::optional<LoadedImage> first;
    for (const Source::File& file : files) {
        auto loaded = decodedFile(file);
        if (!loaded)
            return loaded.error();
        images.push_back(loaded->image);
        if (!first)
            first = std::move(*loaded);
    }
    auto stack = stackOf(files, std::move(images));
    if (!stack)
        return stack.error();
    first->image = std::move(stack->image);
    first->alpha.reset();
    return std::move(*first);
}

} // namespace

Source::Source(File file, LoadedImage loaded)
    : Source(std::vector{std::move(file)}, {}, std::move(loaded)) {}

Source::Source(std::vector<File> files, MaterialMaps maps, LoadedImage loaded)
    : m_files(std::move(files)), m_maps(std::move(maps)), m_facts{loaded.image.size(),
                                                                  loaded.image.channels(),
                                                                  loaded.sampleFormat,
                                                                  loaded.image.transfer(),
                                                                  loaded.iccConverted,
                                                                  loaded.alpha.has_value()},
      m_picture(std::make_shared<const LoadedImage>(std::move(loaded))) {}

Result<Source::Picture> Source::picture() const {
    // Held while decoding: who comes second wants the same picture.
    const std::lock_guard lock(m_mutex);
    if (m_picture)
        return m_picture;
    auto loaded = m_maps.empty() ? decodedFile(m_files.front()) : decodedStack(m_files);
    if (!loaded)
        return loaded.error();
    const Picture picture = std::make_shared<const LoadedImage>(std::move(*loaded));
    if (m_held)
        m_picture = picture;
    return picture;
}

void Source::hold() const {
    m_held = true;
}

void Source::letGo(const std::shared_ptr<const Source>& source) {
    source->m_held = false;
    // Somebody may just be decoding: that must not keep the interface waiting.
    inBackground([source] {
        Picture freed;
        const std::lock_guard lock(source->m_mutex);
        if (!source->m_held)
            freed.swap(source->m_picture);
    });
}

Result<std::shared_ptr<const Source>> openSource(const QString& path, const LoadOptions& options) {
    auto loaded = loadImage(toPath(path), options);
    if (!loaded)
        return loaded.error();
    auto file = readFile(path);
    if (!file)
        return file.error();
    return std::make_shared<const Source>(std::move(*file), std::move(*loaded));
}

Result<Opened> openFile(const QString& path, const LoadOptions& options) {
    auto loaded = loadTextonOrImage(toPath(path), options);
    if (!loaded)
        return loaded.error();
    if (auto* asset = std::get_if<TextonAsset>(&*loaded))
        return Opened(std::make_shared<const TextonAsset>(std::move(*asset)));
    auto file = readFile(path);
    if (!file)
        return file.error();
    return Opened(std::make_shared<const Source>(std::move(*file),
                                                 std::move(std::get<LoadedImage>(*loaded))));
}

Result<std::shared_ptr<const Source>>
decodeSource(const QByteArray& bytes, const QString& name, const LoadOptions& options) {
    auto loaded = decoded(bytes, name, options);
    if (!loaded)
        return loaded.error();
    return std::make_shared<const Source>(
        Source::File{name,
                     {},
                     {},
                     bytes,
                     QCryptographicHash::hash(bytes, QCryptographicHash::Sha256)},
        std::move(*loaded));
}

Result<std::shared_ptr<const Source>> sampleSource(const QString& sample) {
    auto loaded = drawnSample(sample);
    if (!loaded)
        return loaded.error();
    return std::make_shared<const Source>(
        Source::File{sample + QStringLiteral(".png"), {}, sample, {}, {}},
        std::move(*loaded));
}

Result<std::shared_ptr<const Source>> stackSource(const std::vector<Source::Part>& parts) {
    std::vector<Source::Part> ordered = parts;
    std::stable_partition(ordered.begin(), ordered.end(), [](const Source::Part& part) {
        return part.kind == MapKind::Color;
    });
    std::vector<Source::File> files;
    std::vector<Image> images;
    LoadedImage whole;
    for (const Source::Part& part : ordered) {
        const auto picture = part.source->picture();
        if (!picture)
            return picture.error();
        images.push_back((*picture)->image);
        files.push_back(part.source->files().front());
        files.back().map = part.map;
        files.back().kind = part.kind;
        if (files.size() == 1)
            whole = **picture;
        Source::letGo(part.source); // one copy of everything is enough
    }
    whole.image = {};
    auto stack = stackOf(files, std::move(images));
    if (!stack)
        return stack.error();
    whole.image = std::move(stack->image);
    whole.alpha.reset();
    return std::make_shared<const Source>(std::move(files),
                                          std::move(stack->maps),
                                          std::move(whole));
}

Result<std::shared_ptr<const Source>> openStack(const QStringList& paths,
                                                const LoadOptions& options) {
    std::vector<Source::Part> parts;
    for (const QString& path : paths) {
        const auto kind = mapKindOfFileName(QFileInfo(path).fileName().toStdString());
        if (!kind)
            return Error{ErrorCode::InvalidArgument,
                         quoted(toPath(QFileInfo(path).fileName())) +
                             " does not say which map it is; put a word such as color, normal, "
                             "height or roughness into its name, or open it alone"};
        auto source = openSource(path, options);
        if (!source)
            return source.error();
        parts.push_back(
            {std::move(*source), QString::fromStdString(std::string(toString(*kind))), *kind});
    }
    return stackSource(parts);
}

} // namespace txn::app
