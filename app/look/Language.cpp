// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/look/Language.h"

#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace txn::app {
namespace {

const QString kFolder = QStringLiteral(":/i18n");
const QString kPrefix = QStringLiteral("txn_");

} // namespace

void installLanguage(QApplication& application, const QString& language) {
    installTranslations(application, language);
    QApplication::setLayoutDirection(QLocale().textDirection());
}

void installTranslations(QCoreApplication& application, const QString& language) {
    qDeleteAll(application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly));
    const QLocale locale = language.isEmpty() ? QLocale() : QLocale(language);
    QLocale::setDefault(locale);
    // Qt's own texts, such as those of file dialogs, first: ours are asked before them.
    auto* standard = new QTranslator(&application);
    if (standard->load(locale,
                       QStringLiteral("qtbase"),
                       QStringLiteral("_"),
                       QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(standard);
    auto* own = new QTranslator(&application);
    if (own->load(locale, QStringLiteral("txn"), QStringLiteral("_"), kFolder))
        QCoreApplication::installTranslator(own);
}

QString languageName(const QString& language) {
    const QLocale locale(language);
    // Qt says of which country these are, which does not matter here.
    if (locale.language() == QLocale::English)
        return QStringLiteral("English");
    if (locale.language() == QLocale::Spanish)
        return QStringLiteral("Español");
    QString name = locale.nativeLanguageName();
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

QStringList availableLanguages() {
    QStringList languages{QStringLiteral("en")};
    for (const QString& file : QDir(kFolder).entryList({kPrefix + QStringLiteral("*.qm")})) {
        const QString code = file.mid(kPrefix.size(), file.size() - kPrefix.size() - 3);
        if (code != QLatin1String("en"))
            languages.append(code);
    }
    return languages;
}

} // namespace txn::app
