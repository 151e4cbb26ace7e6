// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/Console.h"
#include "core/base/OutputFiles.h"
#include "core/base/Version.h"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>
#include <unistd.h>

namespace {

/// Signal handlers reach nothing but globals.
txn::CancelSource* interrupt = nullptr;

/// How long a job may take to stop by itself.
constexpr unsigned kGraceSeconds = 2;

extern "C" void onInterrupt(int) {
    interrupt->cancel();
    ::alarm(kGraceSeconds);
}

/// Not for signals that are ignored, as under nohup. The second one of a kind ends the program at
/// once.
void listen(int signal, void (*handler)(int)) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN)
        return;
    action = {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

/// Jobs that cannot be stopped halfway end here; files without a name yet vanish.
extern "C" void onGraceOver(int) {
    txn::cli::printStopped();
    ::_exit(1);
}

/// Ctrl-C and kill ask the running job to stop; nothing of it is left behind.
void listenForInterrupts(txn::CancelSource& source) {
    interrupt = &source;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        listen(signal, onInterrupt);
    listen(SIGALRM, onGraceOver);
    txn::letFileSizeLimitsFail();
}

int fail(std::string message, int code) {
    std::replace_if(
        message.begin(),
        message.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        ' ');
    txn::cli::printError("texton: " + message + "\n");
    return code;
}

int printVersion(bool verbose) {
    std::cout << "Texton Studio " << txn::kProgramVersion << '\n';
    if (verbose) {
        for (const char* library : txn::libraryVersions())
            std::cout << library << '\n';
    }
    return std::cout.flush() ? 0 : fail("cannot write to standard output", 1);
}

int run(int argc, char** argv, txn::cli::Session& session) {
    CLI::App app("Textons and endless texture noise from a photograph of a material.", "texton");
    bool version = false;
    bool verbose = false;
    app.add_flag("--version", version, "Tell the version");
    app.add_flag("--verbose", verbose, "With --version: those of all libraries, too");
    app.require_subcommand(0, 1); // none: told below, since an unknown word is told better
    app.footer("Example:\n  texton compute wood.jpg -o wood.exr && "
               "texton noise wood.exr -o wood_4k.png --size 4096x4096\n"
               "'texton SUBCOMMAND --help' explains each one.");
    txn::cli::addCompute(app, session);
    txn::cli::addNoise(app, session);
    txn::cli::addMix(app, session);
    txn::cli::addGaussian(app, session);
    txn::cli::addPeriodic(app, session);
    txn::cli::addSheet(app, session);
    txn::cli::addRender(app, session);
    txn::cli::addCompare(app, session);
    txn::cli::addInfo(app, session);
    txn::cli::addSample(app, session);
    txn::cli::addThumbnail(app, session);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0)
            return app.exit(error); // --help
        return fail(std::string(error.what()) + " (see 'texton --help')", 2);
    }
    if (version)
        return printVersion(verbose);
    if (!session.run)
        return fail("give a subcommand, such as compute or noise (see 'texton --help')", 2);
    const auto result = session.run();
    if (result) {
        if (std::cout.flush())
            return 0;
        return fail("cannot write to standard output", 1);
    }
    if (result.error().code == txn::ErrorCode::Cancelled) {
        txn::cli::printStopped();
        return 1;
    }
    return fail(result.error().message, 1);
}

} // namespace

int main(int argc, char** argv) {
    try {
        txn::cli::hushLibraries();
        static txn::CancelSource source; // signals may come until the very end
        listenForInterrupts(source);
        txn::cli::Session session{source.token(), {}};
        return run(argc, argv, session);
    } catch (const std::bad_alloc&) {
        return fail("out of memory; use a smaller picture, size or support", 1);
    } catch (const std::exception& error) {
        return fail(std::string("internal error: ") + error.what(), 1);
    }
}
