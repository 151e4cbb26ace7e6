// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"

#include <QStringList>

namespace txn::app {

struct SavedProject {
    Project project;
    ViewState view;
    QStringList warnings; ///< one line each, for the message bar
    /// Files outside the project's folder that it wants. None of them was touched, and nothing else
    /// was read: ask, and open it again.
    QStringList outside;
};

/// Projects come from anybody. What else they want is opened only when the user agrees.
struct Trust {
    bool outside = false; ///< files outside the project's folder
    LoadOptions pictures; ///< how large pictures may be

    static constexpr Trust full() { return {true, LoadOptions::insisted()}; }
};

/// Whether the exemplar's bytes go into the project or only its path and content hash.
enum class ExemplarStorage { Embedded, Linked };

/// Project files (.txnproj): CBOR (RFC 8949), self-described, a map whose first entry names format
/// and version; docs/FORMATS.md. They hold data only. The path of a linked exemplar is kept
/// relative to the project's folder; where that would spell out the whole path from the root, the
/// exemplar is embedded all the same, and of a mesh only the name is kept. The thumbnail, a PNG, is
/// for file managers. Any thread; reading decodes the exemplar and may take a while.
[[nodiscard]] QByteArray encodeProject(const Project& project,
                                       const ViewState& view,
                                       ExemplarStorage storage,
                                       const QString& projectFolder,
                                       const QByteArray& thumbnail = {});
/// Errors: Unreadable for what is damaged or of a later version, NotFound for a linked exemplar
/// that has gone, OverBudget for an exemplar that is larger than trust allows; the message names
/// the file.
[[nodiscard]] Result<SavedProject>
decodeProject(const QByteArray& bytes, const QString& path, const Trust& trust = {});

/// The old file or the new one, whole, whatever happens. Errors: Unwritable, naming the file.
[[nodiscard]] Result<void> writeWhole(const QString& path, const QByteArray& bytes);

/// Writes aside and renames: the old file or the new one, whole. Embeds the exemplar unless the
/// project is to be linked.
[[nodiscard]] Result<void> saveProject(const Project& project,
                                       const ViewState& view,
                                       const QString& path,
                                       const QByteArray& thumbnail = {});
[[nodiscard]] Result<SavedProject> openProject(const QString& path, const Trust& trust = {});

} // namespace txn::app
