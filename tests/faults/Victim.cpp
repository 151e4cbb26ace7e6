// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/Victim.h"

#include "app/export/ExportJob.h"
#include "app/files/Autosave.h"
#include "app/files/FileController.h"
#include "app/settings/Settings.h"
#include "core/base/OutputFiles.h"
#include "tests/faults/Shim.h"
#include "tests/helpers/Textons.h"

#include <QApplication>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QWidget>
#include <cstdio>
#include <optional>
#include <unistd.h>

namespace txn::test {
namespace {

using namespace app;

using Outcome = std::optional<QString>;

Texton textonOf(int variant, int channels = 3) {
    TextonRecipe recipe;
    recipe.size = {96, 80};
    recipe.channels = channels;
    recipe.seed = static_cast<std::uint64_t>(variant);
    Texton texton = makeTexton(recipe);
    for (Image& kernel : texton.kernels) {
        for (float& v : kernel.samples())
            v *= 0.05F;
    }
    texton.mean.assign(static_cast<std::size_t>(channels), 0.5);
    return texton;
}

Project projectOf(int variant) {
    Project project;
    auto asset = std::make_shared<TextonAsset>();
    asset->texton = textonOf(variant);
    asset->exemplarName = "stone";
    project.importedTexton = std::move(asset);
    project.noise.contrast = 0.5 * variant;
    return project;
}

ExportSnapshot snapshotOf(int variant, bool isStack) {
    ExportSnapshot snapshot;
    snapshot.name = QStringLiteral("stone");
    snapshot.asset.texton = textonOf(variant, isStack ? 5 : 3);
    if (isStack)
        snapshot.asset.maps = {{"color", MapKind::Color, 3}, {"normal", MapKind::Normal, 2}};
    snapshot.view = QImage(300, 200, QImage::Format_RGB32);
    for (int y = 0; y < snapshot.view.height(); ++y) {
        for (int x = 0; x < snapshot.view.width(); ++x)
            snapshot.view.setPixel(x, y, qRgb(x * variant % 256, x * y % 256, y % 256));
    }
    return snapshot;
}

std::shared_ptr<const MixtureAsset> mixtureOf(int variant) {
    auto mixture = std::make_shared<MixtureAsset>();
    mixture->mixture.textons = {textonOf(variant), textonOf(variant + 2)};
    mixture->mixture.map.rho = Image({64, 48}, 1, 0.25F * static_cast<float>(variant));
    mixture->rhos = {0.0, 1.0};
    mixture->distances = {0.0, 1.0};
    return mixture;
}

/// Saving, as from the menu.
class Saving final : public Victim {
  public:
    explicit Saving(const QString& folder)
        : m_path(folder + QStringLiteral("/work.txnproj")),
          m_settings(m_home.filePath(QStringLiteral("settings.ini"))),
          m_files(m_document, m_runner, m_settings, m_window) {
        const auto fail = [this](const QString& text) {
            m_problem = text;
            m_loop.quit();
        };
        QObject::connect(&m_files, &FileController::problem, fail);
        QObject::connect(&m_files, &FileController::warning, fail);
        QObject::connect(&m_files, &FileController::note, &m_loop, &QEventLoop::quit);
    }
    Outcome write(int variant) override {
        m_problem.reset();
        m_document.reset({}, {}, m_path);
        m_document.change(QStringLiteral("Open"),
                          [&](Project& project) { project = projectOf(variant); });
        m_files.save();
        m_loop.exec();
        return m_problem;
    }
    bool isTold() const override { return m_document.isModified() == m_problem.has_value(); }

  private:
    QString m_path;
    QTemporaryDir m_home;
    Settings m_settings;
    ProjectDocument m_document;
    JobRunner m_runner;
    QWidget m_window;
    FileController m_files;
    QEventLoop m_loop;
    Outcome m_problem;
};

/// Copies of unsaved work.
class Copying final : public Victim {
  public:
    explicit Copying(const QString& folder) : m_autosave(m_document, m_runner, folder, 0) {
        QObject::connect(&m_autosave, &Autosave::failed, [this](const QString& text) {
            m_problem = text;
        });
    }
    Outcome write(int variant) override {
        m_problem.reset();
        m_document.change(QStringLiteral("Open"),
                          [&](Project& project) { project = projectOf(variant); });
        bool begun = false;
        while (!begun || !m_runner.isIdle()) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            begun = begun || m_runner.isBusy(JobKind::Autosave);
        }
        return m_problem;
    }
    bool isTold() const override { return m_document.isModified(); }

  private:
    ProjectDocument m_document;
    JobRunner m_runner;
    Autosave m_autosave;
    Outcome m_problem;
};

class Exporting final : public Victim {
  public:
    Exporting(const QString& kind, const QString& folder) {
        m_plan.folder = folder;
        m_isStack = kind == QLatin1String("maps");
        m_plan.size = {512, 384};
        m_plan.tileable = false;
        m_plan.kind = kind == QLatin1String("texton")    ? ExportKind::Texton
                      : kind == QLatin1String("view")    ? ExportKind::View
                      : kind == QLatin1String("engine")  ? ExportKind::Engine
                      : kind == QLatin1String("mixture") ? ExportKind::Mixture
                                                         : ExportKind::Noise;
        m_plan.textonPng = m_plan.textonFile = true;
        m_plan.nameTemplate = QStringLiteral("stone");
    }
    Outcome write(int variant) override {
        class Context final : public JobContext {
          public:
            const CancelToken& token() const override { return m_token; }
            void setProgress(double) override {}
            void deliver(Delivery) override {}

          private:
            CancelToken m_token;
        } context;
        ExportSnapshot snapshot = snapshotOf(variant, m_isStack);
        if (m_plan.kind == ExportKind::Mixture)
            snapshot.mixture = mixtureOf(variant);
        const auto done = runExport(m_plan, snapshot, context);
        return done ? Outcome() : Outcome(QString::fromStdString(done.error().message));
    }

  private:
    ExportPlan m_plan;
    bool m_isStack = false;
};

} // namespace

std::unique_ptr<Victim> makeVictim(const QString& kind, const QString& folder) {
    if (kind == QLatin1String("project"))
        return std::make_unique<Saving>(folder);
    if (kind == QLatin1String("autosave"))
        return std::make_unique<Copying>(folder);
    return std::make_unique<Exporting>(kind, folder);
}

void runVictim(int& argc, char** argv) {
    letFileSizeLimitsFail();
    const QStringList arguments(argv + 2, argv + argc);
    const QString kind = arguments.value(0);
    const int variant = arguments.value(2).toInt();
    const bool hasWindow = kind == QLatin1String("project");
    const std::unique_ptr<QCoreApplication> application(
        hasWindow ? new QApplication(argc, argv) : new QCoreApplication(argc, argv));
    QCoreApplication::setApplicationName(QStringLiteral("victim"));
    // Faults come once all is set up.
    const QByteArray fault = qgetenv("TXN_FAULT");
    const auto isOn = [](const char* name) { return qgetenv(name) != "0"; };
    const auto arm = [&](const char* what) {
        setFault(what,
                 qgetenv("TXN_FAULT_UNDER").constData(),
                 isOn("TXN_NAMELESS"),
                 isOn("TXN_HARD_LINKS"));
    };
    arm(nullptr);
    const auto victim = makeVictim(kind, arguments.value(1));
    if (variant == 2 && kind == QLatin1String("autosave")) // its files have names by chance
        static_cast<void>(victim->write(1));
    arm(fault.isEmpty() ? nullptr : fault.constData());
    if (variant != 0) {
        const Outcome problem = victim->write(variant);
        if (problem)
            std::fprintf(stderr, "%s\n", qPrintable(*problem));
        ::_exit(!victim->isTold() ? kUntold : problem ? kRefused : kDone);
    }
    std::puts("begun");
    std::fflush(stdout);
    for (int i = 0;; ++i)
        static_cast<void>(victim->write(1 + i % 2));
}

} // namespace txn::test
