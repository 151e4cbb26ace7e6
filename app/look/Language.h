// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QApplication;
class QCoreApplication;

namespace txn::app {

/// Texts, numbers and reading direction in the given language; empty: that of the system. Where
/// there is no translation, English. Call before any window is made.
void installLanguage(QApplication& application, const QString& language);

/// The same without the reading direction, for programs without a window.
void installTranslations(QCoreApplication& application, const QString& language);

/// Its name in itself, such as "Deutsch" for "de".
[[nodiscard]] QString languageName(const QString& language);

/// Codes of the languages that there are translations for, English first.
[[nodiscard]] QStringList availableLanguages();

} // namespace txn::app
