// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Application.h"
#include "app/MainWindow.h"
#include "app/look/Language.h"
#include "app/look/Theme.h"
#include "app/memory/Guarded.h"
#include "core/base/OutputFiles.h"
#include "core/base/Version.h"

#include <QApplication>
#include <QCommandLineParser>
#include <cstdio>
#include <memory>

namespace {

struct Help {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

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

void printVersion(bool verbose) {
    print(stdout, QStringLiteral("texton-studio %1").arg(QCoreApplication::applicationVersion()));
    if (!verbose)
        return;
    for (const char* library : txn::libraryVersions())
        print(stdout, QLatin1String(library));
    // Qt comes in versions that programs built with others run with.
    print(stdout, QStringLiteral("Qt, running: %1").arg(QLatin1String(qVersion())));
}

/// What may be asked for on the command line. Its texts are in the language of the moment.
struct Options {
    QCommandLineOption help{{QStringLiteral("h"), QStringLiteral("help")},
                            Help::tr("Show this help.")};
    QCommandLineOption version{{QStringLiteral("v"), QStringLiteral("version")},
                               Help::tr("Show the version.")};
    QCommandLineOption verbose{QStringLiteral("verbose"),
                               Help::tr("With --version: those of all libraries, too.")};
    QCommandLineOption language{QStringLiteral("lang"),
                                Help::tr("Language of the window, such as en or fr."),
                                Help::tr("LANGUAGE")};
    QCommandLineParser parser;

    Options() {
        parser.setApplicationDescription(Help::tr(
            "Makes endless material from a photo. FILES may be photos, textons or a project."));
        parser.addOptions({help, version, verbose, language});
        parser.addPositionalArgument(QStringLiteral("FILES"),
                                     Help::tr("What to open."),
                                     QStringLiteral("[FILES...]"));
    }
};

} // namespace

int main(int argc, char** argv) {
    txn::letFileSizeLimitsFail();
    QCoreApplication::setApplicationName(QStringLiteral("texton-studio"));
    QCoreApplication::setApplicationVersion(QLatin1String(txn::kProgramVersion));
    QStringList arguments;
    for (int i = 0; i < argc; ++i)
        arguments.append(QString::fromLocal8Bit(argv[i]));

    Options options;
    if (!options.parser.parse(arguments)) {
        print(stderr,
              Help::tr("texton-studio: %1 See texton-studio --help.")
                  .arg(options.parser.errorText()));
        return 2;
    }
    const QString asked = options.parser.value(options.language);
    if (options.parser.isSet(options.version)) {
        printVersion(options.parser.isSet(options.verbose));
        return 0;
    }
    if (options.parser.isSet(options.help)) { // needs no display
        QCoreApplication application(argc, argv);
        txn::app::installTranslations(application, asked);
        Options translated;
        translated.parser.parse(arguments);
        print(stdout, translated.parser.helpText());
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
    txn::app::Guarded<QApplication> application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Texton Studio"));
    QApplication::setDesktopFileName(QStringLiteral(TXN_APP_ID));
    txn::app::Settings settings;
    const QString language = asked.isEmpty() ? settings.language() : asked;
    txn::app::installLanguage(application, language);
    txn::app::applyTheme(application, settings.theme());
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/texton-studio.svg")));

    txn::app::Application studio(settings, txn::app::Application::standardRecoveryFolder());
    application.outOfMemory = [&studio] { studio.window().sayOutOfMemory(); };
    studio.window().show();
    studio.start(options.parser.positionalArguments());
    return QApplication::exec();
}
