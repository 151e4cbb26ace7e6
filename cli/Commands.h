// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Result.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace txn::cli {

/// What the subcommands share with main(): the Ctrl-C flag, and what to do once the command line
/// has been understood.
struct Session {
    CancelToken cancel;
    std::function<Result<void>()> run;
};

void addCompute(CLI::App& app, Session& session);
void addGaussian(CLI::App& app, Session& session);
void addPeriodic(CLI::App& app, Session& session);
void addMix(CLI::App& app, Session& session);
void addNoise(CLI::App& app, Session& session);
void addRender(CLI::App& app, Session& session);
void addCompare(CLI::App& app, Session& session);
void addSheet(CLI::App& app, Session& session);
void addInfo(CLI::App& app, Session& session);
void addSample(CLI::App& app, Session& session);
void addThumbnail(CLI::App& app, Session& session);

} // namespace txn::cli
