// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/TextonAsset.h"
#include "core/image/ImageIo.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <atomic>
#include <memory>
#include <mutex>
#include <variant>
#include <vector>

namespace txn::app {

/// What the artist opened, as it was opened: the bytes of a picture's file, or of those of the maps
/// of one material, and the picture in them as long as somebody needs it. Immutable to its users,
/// shared between threads and between steps of the undo stack, where bytes cost little and decoded
/// pictures much.
class Source {
  public:
    using Picture = std::shared_ptr<const LoadedImage>;
    struct File {
        QString name;     ///< without folders, or the sample's
        QString path;     ///< absolute; empty for samples and pasted pictures
        QString sample;   ///< of a generated sample: its name in the catalog
        QByteArray bytes; ///< empty for samples
        QByteArray hash;  ///< SHA-256 of the bytes
        QString map{};    ///< of a stack: what the map is called
        MapKind kind = MapKind::Color;
    };
    /// A picture that is to become a map of a stack.
    struct Part {
        std::shared_ptr<const Source> source;
        QString map;
        MapKind kind = MapKind::Data;
    };
    /// What there is to know without the pixels.
    struct Facts {
        Size size;
        int channels = 0;
        SampleFormat sampleFormat{};
        Transfer transfer{};
        bool iccConverted = false;
        bool hasAlpha = false;
    };

    Source(File file, LoadedImage loaded);
    /// Of a stack: one file for each map.
    Source(std::vector<File> files, MaterialMaps maps, LoadedImage stack);

    // Of the picture, or of a stack's first map.
    const QString& name() const { return m_files.front().name; }
    const QString& path() const { return m_files.front().path; }
    const QString& sample() const { return m_files.front().sample; }
    const QByteArray& bytes() const { return m_files.front().bytes; }
    const QByteArray& hash() const { return m_files.front().hash; }
    const std::vector<File>& files() const { return m_files; }
    const MaterialMaps& maps() const { return m_maps; } ///< empty for a plain picture
    const Facts& facts() const { return m_facts; }
    Size size() const { return m_facts.size; }

    /// The picture, decoded again if it was let go: may take long. Any thread. Errors: those of
    /// loadImage.
    [[nodiscard]] Result<Picture> picture() const;
    /// Whether the pixels are kept for the next one who asks; they are at first. Letting go frees
    /// them in the background. Any thread.
    void hold() const;
    static void letGo(const std::shared_ptr<const Source>& source);

  private:
    std::vector<File> m_files;
    MaterialMaps m_maps;
    Facts m_facts;
    mutable std::atomic<bool> m_held{true};
    mutable std::mutex m_mutex; ///< of m_picture
    mutable Picture m_picture;
};

/// Reads and decodes a picture. Any thread. Errors: those of loadImage; the message names the file.
[[nodiscard]] Result<std::shared_ptr<const Source>> openSource(const QString& path,
                                                               const LoadOptions& options = {});

/// A texton where the file says that it is one, a picture otherwise.
using Opened = std::variant<std::shared_ptr<const Source>, std::shared_ptr<const TextonAsset>>;
[[nodiscard]] Result<Opened> openFile(const QString& path, const LoadOptions& options = {});

/// A picture that came as bytes (pasted, or embedded in a project) under the given name.
[[nodiscard]] Result<std::shared_ptr<const Source>>
decodeSource(const QByteArray& bytes, const QString& name, const LoadOptions& options = {});

/// Registered maps of one material as one source; colors come first. Errors: those of stackMaps and
/// of reading.
[[nodiscard]] Result<std::shared_ptr<const Source>>
stackSource(const std::vector<Source::Part>& parts);
/// The same from files whose names tell which maps they are. Errors: InvalidArgument for one that
/// does not.
[[nodiscard]] Result<std::shared_ptr<const Source>> openStack(const QStringList& paths,
                                                              const LoadOptions& options = {});

/// One of sampleCatalog(). Errors: InvalidArgument for another name.
[[nodiscard]] Result<std::shared_ptr<const Source>> sampleSource(const QString& sample);

} // namespace txn::app
