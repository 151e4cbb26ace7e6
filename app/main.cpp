// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Application.h"
#include "app/MainWindow.h"
#include "app/look/Language.h"
#include "app/look/Theme.h"
#include "core/base/Version.h"

#include <QApplication>
#include <QCommandLineParser>
#include <cstdio>
#include <memory>

namespace {

constexpr const char* kHelp =
    "Makes endless material from a photo. FILES may be photos, textons or a project.";

bool hasDisplay() {
#if defined(Q_OS_LINUX)
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

void print(FILE* stream, const QString& text) {
    std::fputs(qPrintable(text + QLatin1Char('\n')), stream);
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName(QStringLiteral("texton-studio"));
    QCoreApplication::setApplicationVersion(QLatin1String(txn::kProgramVersion));
    QStringList arguments;
    for (int i = 0; i < argc; ++i)
        arguments.append(QString::fromLocal8Bit(argv[i]));

    // Help must not need a display.
    QCommandLineParser parser;
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")},
                                  QStringLiteral("Show this help."));
    const QCommandLineOption version({QStringLiteral("v"), QStringLiteral("version")},
                                     QStringLiteral("Show the version."));
    const QCommandLineOption lang(QStringLiteral("lang"),
                                  QStringLiteral("Language of the window, such as en or fr."),
                                  QStringLiteral("LANGUAGE"));
    parser.setApplicationDescription(QLatin1String(kHelp));
    parser.addOptions({help, version, lang});
    parser.addPositionalArgument(QStringLiteral("FILES"),
                                 QStringLiteral("What to open."),
                                 QStringLiteral("[FILES...]"));
    if (!parser.parse(arguments)) {
        print(stderr, QStringLiteral("texton-studio: %1").arg(parser.errorText()));
        return 2;
    }
    if (parser.isSet(version)) {
        print(stdout,
              QStringLiteral("texton-studio %1").arg(QCoreApplication::applicationVersion()));
        return 0;
    }
    if (parser.isSet(help)) {
        const QCoreApplication names(argc, argv);
        print(stdout, parser.helpText());
        return 0;
    }
    if (!hasDisplay()) {
        print(stderr,
              QStringLiteral(
                  "texton-studio: there is no display; please start it from a desktop, or use the "
                  "command line program texton"));
        return 1;
    }

    // Whatever else draws with OpenGL in this process, such as a platform plug-in, keeps its
    // objects when its window is docked elsewhere. Our own noise has a context of its own.
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Texton Studio"));
    QApplication::setDesktopFileName(QStringLiteral("texton-studio"));
    txn::app::Settings settings;
    const QString language = parser.isSet(lang) ? parser.value(lang) : settings.language();
    txn::app::installLanguage(application, language);
    txn::app::applyTheme(application, settings.theme());
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/texton-studio.svg")));

    txn::app::Application studio(settings, txn::app::Application::standardRecoveryFolder());
    studio.window().show();
    studio.start(parser.positionalArguments());
    return QApplication::exec();
}
