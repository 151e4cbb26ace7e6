// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/ExportJob.h"

#include "app/export/EngineExport.h"
#include "core/bake/Bake.h"
#include "core/base/OutputFiles.h"
#include "core/export/Exporter.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <cmath>

namespace txn::app {
namespace {

std::filesystem::path toPath(const QString& name) {
    return {QFile::encodeName(name).toStdString()};
}

NoiseParams noiseParams(const NoiseSettings& noise) {
    return {noise.process, noise.meanImpacts, noise.seed, std::nullopt};
}

const Error kCancelled{ErrorCode::Cancelled, "cancelled"};

/// files: as of exportFiles, of which every output has its sidecar.
Result<void> writeTexton(const QStringList& files, const ExportSnapshot& snapshot) {
    const QLatin1String sidecar(".json");
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files) {
        if (file.endsWith(sidecar))
            paths.push_back(toPath(file.chopped(sidecar.size())));
    }
    if (paths.empty())
        return Error{ErrorCode::InvalidArgument, "choose at least one kind of file"};
    auto written = saveTexton(snapshot.asset, paths);
    return written ? Result<void>() : written.error();
}

/// All of a mixture into a folder of its own.
Result<void> writeMixture(const ExportPlan& plan, const ExportSnapshot& snapshot) {
    if (!snapshot.mixture)
        return Error{ErrorCode::InvalidArgument, "open a second material first, to mix it"};
    const auto saved = saveMixture(*snapshot.mixture,
                                   toPath(QDir(plan.folder).filePath(exportName(plan, snapshot))));
    return saved ? Result<void>() : saved.error();
}

Result<double> writeNoise(const QString& file,
                          const ExportPlan& plan,
                          const ExportSnapshot& snapshot,
                          JobContext& context) {
    const double scale = snapshot.noise.scale;
    NoiseParams params = noiseParams(snapshot.noise);
    if (plan.tileable)
        params.period = Period{plan.size.width / scale, plan.size.height / scale};
    Rect rect{plan.tileable ? 0 : plan.originX, plan.tileable ? 0 : plan.originY, plan.size};
    Mixture mixture(snapshot.asset.texton);
    if (snapshot.mixture) {
        mixture = snapshot.mixture->mixture;
        params.process = snapshot.mixture->process;
        // From the corner of the map on: that is what was painted.
        rect.x += std::llround(mixture.map.placement.left * scale);
        rect.y += std::llround(mixture.map.placement.top * scale);
    }
    const auto grid = NoiseGrid::create(std::move(mixture), params, scale);
    if (!grid)
        return grid.error();
    SaveOptions options;
    options.sampleFormat = plan.depth;
    const auto report = bake(
        *grid,
        rect,
        {toPath(file), options, snapshot.asset.maps},
        [&](double share) { context.setProgress(share); },
        context.token());
    if (!report)
        return report.error();
    return report->clippedShare;
}

} // namespace

Result<void> saveView(const QString& file, const QImage& view) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (view.isNull() || !buffer.open(QIODevice::WriteOnly) ||
        !view.convertToFormat(QImage::Format_RGB32).save(&buffer, "PNG"))
        return Error{ErrorCode::InvalidArgument, "there is no noise on screen to save"};
    OutputFiles output;
    if (auto ok = output.addText(toPath(file),
                                 {bytes.constData(), static_cast<std::size_t>(bytes.size())});
        !ok)
        return ok.error();
    return output.commit();
}

namespace {

/// files: as of exportFiles for engines.
Result<void> writeEngine(const QStringList& files,
                         const ExportPlan& plan,
                         const ExportSnapshot& snapshot,
                         const JobContext& context) {
    const Texton& texton = snapshot.asset.texton;
    const NoiseParams noise = noiseParams(snapshot.noise);
    auto shader = engineShader(texton, noise);
    if (!shader)
        return shader.error();
    auto example = engineExample(texton, exportName(plan, snapshot).toStdString());
    if (!example)
        return example.error();
    OutputFiles output;
    const std::array texts{std::move(*shader),
                           kernelTexels(texton),
                           engineParameters(texton, noise),
                           std::move(*example)};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (auto ok = output.addText(toPath(files[static_cast<qsizetype>(i) + 2]), texts[i]); !ok)
            return ok.error();
    }
    if (context.cancelled())
        return kCancelled;
    std::vector<std::filesystem::path> written;
    if (auto ok = addTexton(snapshot.asset, toPath(files[0]), output, written); !ok)
        return ok;
    return output.commit();
}

} // namespace

Result<ExportReport>
runExport(const ExportPlan& plan, const ExportSnapshot& snapshot, JobContext& context) {
    ExportReport report;
    report.files = exportFiles(plan, snapshot);
    if (context.cancelled())
        return kCancelled;
    Result<void> done;
    switch (plan.kind) {
    case ExportKind::Texton:
        done = writeTexton(report.files, snapshot);
        break;
    case ExportKind::Noise: {
        const auto clipped = writeNoise(noiseFile(plan, snapshot), plan, snapshot, context);
        if (!clipped)
            return clipped.error();
        report.clippedShare = *clipped;
        break;
    }
    case ExportKind::View:
        done = saveView(report.files.front(), snapshot.view);
        break;
    case ExportKind::Mixture:
        done = writeMixture(plan, snapshot);
        break;
    case ExportKind::Engine:
        done = writeEngine(report.files, plan, snapshot, context);
        break;
    }
    if (!done)
        return done.error();
    return report;
}

} // namespace txn::app
