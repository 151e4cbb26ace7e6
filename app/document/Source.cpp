// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Source.h"

#include "core/export/Exporter.h"
#include "core/samples/Samples.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryFile>

namespace txn::app {
namespace {

constexpr Size kSampleSize{512, 512};

QByteArray contentHash(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

std::filesystem::path toPath(const QString& name) {
    return {QFile::encodeName(name).toStdString()};
}

Result<std::shared_ptr<const Source>> withBytes(const QString& path, LoadedImage loaded) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{ErrorCode::Unreadable,
                     quoted(toPath(path)) + ": " + file.errorString().toStdString()};
    auto source = std::make_shared<Source>();
    source->name = QFileInfo(path).fileName();
    source->path = QFileInfo(path).absoluteFilePath();
    source->bytes = file.readAll();
    source->hash = contentHash(source->bytes);
    source->loaded = std::move(loaded);
    return std::shared_ptr<const Source>(std::move(source));
}

} // namespace

Result<std::shared_ptr<const Source>> openSource(const QString& path) {
    auto loaded = loadImage(toPath(path));
    if (!loaded)
        return loaded.error();
    return withBytes(path, std::move(*loaded));
}

Result<Opened> openFile(const QString& path) {
    auto loaded = loadTextonOrImage(toPath(path));
    if (!loaded)
        return loaded.error();
    if (auto* asset = std::get_if<TextonAsset>(&*loaded))
        return Opened(std::make_shared<const TextonAsset>(std::move(*asset)));
    auto source = withBytes(path, std::move(std::get<LoadedImage>(*loaded)));
    if (!source)
        return source.error();
    return Opened(std::move(*source));
}

Result<std::shared_ptr<const Source>> decodeSource(const QByteArray& bytes, const QString& name) {
    // The decoders read files only.
    QTemporaryFile file;
    if (!file.open() || file.write(bytes) != bytes.size() || !file.flush())
        return Error{
            ErrorCode::Unwritable,
            "cannot unpack '" + name.toStdString() +
                "' into the folder for temporary files: " + file.errorString().toStdString()};
    auto loaded = loadImage(toPath(file.fileName()));
    if (!loaded) {
        QString message = QString::fromStdString(loaded.error().message);
        message.replace(file.fileName(), name);
        return Error{loaded.error().code, message.toStdString()};
    }
    auto source = std::make_shared<Source>();
    source->name = name;
    source->bytes = bytes;
    source->hash = contentHash(bytes);
    source->loaded = std::move(*loaded);
    return std::shared_ptr<const Source>(std::move(source));
}

Result<std::shared_ptr<const Source>> sampleSource(const QString& sample) {
    auto image = makeSample(sample.toStdString(), kSampleSize, Seed{1});
    if (!image)
        return image.error();
    auto source = std::make_shared<Source>();
    source->name = sample + QStringLiteral(".png");
    source->sample = sample;
    source->loaded.image = std::move(*image);
    source->loaded.channelNames = {"R", "G", "B"};
    return std::shared_ptr<const Source>(std::move(source));
}

} // namespace txn::app
