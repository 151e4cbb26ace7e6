// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/TextonAsset.h"
#include "core/image/ImageIo.h"

#include <QByteArray>
#include <QString>
#include <memory>
#include <variant>

namespace txn::app {

/// What the artist opened, as it was opened: the file's bytes and the picture in them. Immutable,
/// shared between threads and between steps of the undo stack.
struct Source {
    QString name;     ///< the file's name without folders, or the sample's
    QString path;     ///< absolute; empty for samples and pasted pictures
    QString sample;   ///< of a generated sample: its name in the catalog
    QByteArray bytes; ///< of the file; empty for samples
    QByteArray hash;  ///< SHA-256 of the bytes
    LoadedImage loaded;

    Size size() const { return loaded.image.size(); }
};

/// Reads and decodes a picture. Any thread. Errors: those of loadImage; the message names the file.
[[nodiscard]] Result<std::shared_ptr<const Source>> openSource(const QString& path);

/// A texton where the file says that it is one, a picture otherwise.
using Opened = std::variant<std::shared_ptr<const Source>, std::shared_ptr<const TextonAsset>>;
[[nodiscard]] Result<Opened> openFile(const QString& path);

/// A picture that came as bytes (pasted, or embedded in a project) under the given name.
[[nodiscard]] Result<std::shared_ptr<const Source>> decodeSource(const QByteArray& bytes,
                                                                 const QString& name);

/// One of sampleCatalog(). Errors: InvalidArgument for another name.
[[nodiscard]] Result<std::shared_ptr<const Source>> sampleSource(const QString& sample);

} // namespace txn::app
