// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QStringList>
#include <cstddef>

namespace txn::app {

enum class ThemeChoice { Dark, Light, System };
enum class Surround { Grey, Black, White };

/// What the program remembers between runs, typed. Kept in the user's own settings file; tests give
/// another one. Interface thread.
class Settings {
  public:
    static constexpr int kMaxRecentFiles = 12;

    Settings();
    explicit Settings(const QString& file);

    ThemeChoice theme() const;
    void setTheme(ThemeChoice theme);
    Surround surround() const;
    void setSurround(Surround surround);
    /// How many samples a picture may have before the user is asked; of the settings file only.
    std::size_t pictureBudget() const;
    /// Such as "fr"; empty: that of the system.
    QString language() const;
    void setLanguage(const QString& language);

    /// Newest first, absolute paths.
    QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);
    void clearRecentFiles();

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

    /// Shortcuts that differ from the default, by the action's id.
    QString shortcut(const QString& action, const QString& standard) const;
    void setShortcut(const QString& action, const QString& shortcut, const QString& standard);

    QString folder(const QString& purpose) const; ///< last used; empty: none yet
    void setFolder(const QString& purpose, const QString& folder);

    /// For presets and the like: a JSON text by name.
    QByteArray json(const QString& name) const;
    void setJson(const QString& name, const QByteArray& json);

  private:
    QSettings m_settings;
};

} // namespace txn::app
