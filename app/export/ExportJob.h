// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/ExportPlan.h"
#include "app/jobs/JobRunner.h"

namespace txn::app {

struct ExportReport {
    QStringList files;
    double clippedShare = 0.0;
};

/// Writes the files of exportFiles(plan, snapshot); they appear when they are whole. Errors: those
/// of the writers, naming the file; InvalidArgument where nothing is chosen; Cancelled.
[[nodiscard]] Result<ExportReport>
runExport(const ExportPlan& plan, const ExportSnapshot& snapshot, JobContext& context);

/// What is on screen as a PNG file, whole or not at all. Any thread. Errors: InvalidArgument for no
/// picture, Unwritable.
[[nodiscard]] Result<void> saveView(const QString& file, const QImage& view);

} // namespace txn::app
