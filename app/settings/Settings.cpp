// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/Settings.h"

#include "core/image/ImageIo.h"

#include <QFileInfo>
#include <algorithm>

namespace txn::app {
namespace {

template <class Choice>
Choice read(const QSettings& settings, const char* key, Choice last) {
    const int value = settings.value(QLatin1String(key), 0).toInt();
    return static_cast<Choice>(std::clamp(value, 0, static_cast<int>(last)));
}

} // namespace

Settings::Settings()
    : m_settings(QSettings::IniFormat,
                 QSettings::UserScope,
                 QStringLiteral("texton-studio"),
                 QStringLiteral("texton-studio")) {}

Settings::Settings(const QString& file) : m_settings(file, QSettings::IniFormat) {}

ThemeChoice Settings::theme() const {
    return read(m_settings, "look/theme", ThemeChoice::System);
}
void Settings::setTheme(ThemeChoice theme) {
    m_settings.setValue(QStringLiteral("look/theme"), static_cast<int>(theme));
}

Surround Settings::surround() const {
    return read(m_settings, "look/surround", Surround::White);
}
void Settings::setSurround(Surround surround) {
    m_settings.setValue(QStringLiteral("look/surround"), static_cast<int>(surround));
}

std::size_t Settings::pictureBudget() const {
    bool isNumber = false;
    const qulonglong budget =
        m_settings.value(QStringLiteral("open/pictureBudget")).toULongLong(&isNumber);
    return isNumber ? budget : LoadOptions{}.maxSamples;
}

QString Settings::language() const {
    return m_settings.value(QStringLiteral("look/language")).toString();
}
void Settings::setLanguage(const QString& language) {
    m_settings.setValue(QStringLiteral("look/language"), language);
}

QStringList Settings::recentFiles() const {
    return m_settings.value(QStringLiteral("files/recent")).toStringList();
}
void Settings::addRecentFile(const QString& path) {
    QStringList files = recentFiles();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    while (files.size() > kMaxRecentFiles)
        files.removeLast();
    m_settings.setValue(QStringLiteral("files/recent"), files);
}
void Settings::removeRecentFile(const QString& path) {
    QStringList files = recentFiles();
    files.removeAll(QFileInfo(path).absoluteFilePath());
    m_settings.setValue(QStringLiteral("files/recent"), files);
}
void Settings::clearRecentFiles() {
    m_settings.remove(QStringLiteral("files/recent"));
}

QByteArray Settings::windowGeometry() const {
    return m_settings.value(QStringLiteral("window/geometry")).toByteArray();
}
QByteArray Settings::windowState() const {
    return m_settings.value(QStringLiteral("window/state")).toByteArray();
}
void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
    m_settings.setValue(QStringLiteral("window/geometry"), geometry);
    m_settings.setValue(QStringLiteral("window/state"), state);
}
QString Settings::shortcut(const QString& action, const QString& standard) const {
    return m_settings.value(QStringLiteral("shortcuts/") + action, standard).toString();
}
void Settings::setShortcut(const QString& action,
                           const QString& shortcut,
                           const QString& standard) {
    const QString key = QStringLiteral("shortcuts/") + action;
    if (shortcut == standard)
        m_settings.remove(key);
    else
        m_settings.setValue(key, shortcut);
}

QString Settings::folder(const QString& purpose) const {
    return m_settings.value(QStringLiteral("folders/") + purpose).toString();
}
void Settings::setFolder(const QString& purpose, const QString& folder) {
    m_settings.setValue(QStringLiteral("folders/") + purpose, folder);
}

QByteArray Settings::json(const QString& name) const {
    return m_settings.value(QStringLiteral("data/") + name).toByteArray();
}
void Settings::setJson(const QString& name, const QByteArray& json) {
    m_settings.setValue(QStringLiteral("data/") + name, json);
}

} // namespace txn::app
