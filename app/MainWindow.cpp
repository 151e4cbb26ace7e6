// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/document/ProjectDocument.h"
#include "app/files/FileController.h"
#include "app/look/Theme.h"
#include "app/mixing/MapPainter.h"
#include "app/mixing/MixEditor.h"
#include "app/panels/ExemplarPanel.h"
#include "app/panels/HistogramPanel.h"
#include "app/panels/JobsPanel.h"
#include "app/panels/JobsStatus.h"
#include "app/panels/MixPanel.h"
#include "app/panels/NoisePanel.h"
#include "app/panels/SpectrumPanel.h"
#include "app/panels/TextonPanel.h"
#include "app/pipeline/Pipeline.h"
#include "app/settings/Settings.h"
#include "app/views/NoiseService.h"
#include "app/views/ViewArea.h"
#include "app/widgets/ActionRegistry.h"
#include "app/widgets/MessageBar.h"
#include "app/widgets/WhatsThis.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QStatusBar>
#include <QTimer>
#include <QUndoView>
#include <QVBoxLayout>

namespace txn::app {
namespace {

constexpr int kStateVersion = 1;
constexpr int kSaveMs = 50;
constexpr QSize kFirstSize{1440, 900};
constexpr int kLeftWidth = 304;
constexpr int kRightWidth = 340;
constexpr int kBottomHeight = 216;
constexpr int kTextonHeight = 460;
constexpr int kNoiseHeight = 392;

} // namespace

MainWindow::MainWindow(const Parts& parts)
    : m_settings(parts.settings), m_document(parts.document), m_runner(parts.runner),
      m_pipeline(parts.pipeline), m_noise(parts.noise),
      m_files(new FileController(m_document, m_runner, m_settings, *this)),
      m_actions(new ActionRegistry(m_settings, this)), m_messages(new MessageBar),
      m_tools(new PaintTools(this)),
      m_painter(new MapPainter(m_document, m_pipeline, *m_tools, this)),
      m_mix(new MixEditor(m_document, m_runner, this)),
      m_views(new ViewArea(m_document, m_pipeline, m_noise, m_settings, *m_painter)) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    auto* center = new QWidget;
    auto* column = new QVBoxLayout(center);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_messages);
    column->addWidget(m_views, 1);
    setCentralWidget(center);
    createDocks();
    createStatusBar();
    createActions();
    createMenus();
    explainByToolTips(*this);

    const auto problem = [this](const QString& text) {
        m_messages->show(MessageBar::Kind::Problem, text);
    };
    connect(m_files, &FileController::problem, this, problem);
    connect(m_files, &FileController::note, this, [this](const QString& text) {
        m_messages->show(MessageBar::Kind::Note, text);
    });
    connect(m_files, &FileController::warning, this, [this](const QString& text) {
        m_messages->show(MessageBar::Kind::Warning, text);
    });
    connect(m_mix, &MixEditor::problem, this, problem);
    connect(m_mix, &MixEditor::note, this, [this](const QString& text) {
        m_messages->show(MessageBar::Kind::Note, text);
    });
    connect(m_views, &ViewArea::problem, this, problem);
    connect(&m_pipeline, &Pipeline::failed, this, problem);
    connect(&m_runner,
            &JobRunner::jobFailed,
            this,
            [this, problem](JobKind kind, const QString& reason) {
                if (kind == JobKind::Mix)
                    m_pipeline.cancelMix();
                problem(tr("That did not work: %1").arg(reason));
            });
    connect(&m_noise, &NoiseService::ready, this, [this] {
        // "llvmpipe (LLVM 15.0.6, 256 bits)": the name will do.
        m_renderer->setText(m_noise.renderer().section(QLatin1Char('('), 0, 0).trimmed());
        m_renderer->setToolTip(tr("What draws the noise: %1").arg(m_noise.renderer()));
        if (!m_noise.problem().isEmpty())
            m_messages->show(MessageBar::Kind::Warning,
                             tr("The noise is drawn without the graphics card, from above only: %1")
                                 .arg(m_noise.problem()));
    });
    connect(&m_document, &ProjectDocument::titleChanged, this, &MainWindow::showTitle);
    showTitle();

    resize(kFirstSize);
    arrangeDocks();
    restoreGeometry(m_settings.windowGeometry());
    restoreState(m_settings.windowState(), kStateVersion);
}

MainWindow::~MainWindow() {
    // While everything that hears of it still lives.
    hide();
}

QDockWidget* MainWindow::addDock(const QString& id,
                                 const QString& title,
                                 QWidget* content,
                                 Qt::DockWidgetArea area,
                                 bool scrolls) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(id);
    if (scrolls) {
        auto* scroll = new QScrollArea;
        scroll->setWidgetResizable(true);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setFocusPolicy(Qt::NoFocus);
        scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        scroll->setMinimumWidth(content->minimumSizeHint().width() + 16);
        scroll->setWidget(content);
        dock->setWidget(scroll);
    } else {
        dock->setWidget(content);
    }
    addDockWidget(area, dock);
    m_docks[id] = dock;
    return dock;
}

void MainWindow::createDocks() {
    addDock(QStringLiteral("exemplarDock"),
            tr("Exemplar"),
            new ExemplarPanel(m_document, m_pipeline),
            Qt::LeftDockWidgetArea,
            true);
    addDock(QStringLiteral("textonDock"),
            tr("Texton"),
            new TextonPanel(m_document, m_pipeline, m_runner),
            Qt::RightDockWidgetArea,
            true);
    m_noisePanel = new NoisePanel(m_document, m_settings);
    addDock(QStringLiteral("noiseDock"), tr("Noise"), m_noisePanel, Qt::RightDockWidgetArea, true);
    connect(m_noisePanel, &NoisePanel::screenshotRequested, this, &MainWindow::saveScreenshot);
    connect(m_views, &ViewArea::noiseFrameShown, m_noisePanel, &NoisePanel::showFrame);

    const auto addAnalysis = [this](const QString& id, const QString& title, QWidget* panel) {
        QDockWidget* dock = addDock(id, title, panel, Qt::BottomDockWidgetArea, false);
        connect(dock, &QDockWidget::visibilityChanged, this, [this] {
            const auto seen = [this](const char* name) {
                const QDockWidget* each = m_docks.at(QLatin1String(name));
                return each->isVisible() && !each->visibleRegion().isEmpty();
            };
            m_pipeline.setAnalysisWanted(seen("spectrumDock") || seen("histogramDock"));
        });
    };
    m_docks[QStringLiteral("histogramDock")] = nullptr;
    addAnalysis(QStringLiteral("spectrumDock"), tr("Spectrum"), new SpectrumPanel(m_pipeline));
    addAnalysis(QStringLiteral("histogramDock"), tr("Histogram"), new HistogramPanel(m_pipeline));
    m_mixPanel = new MixPanel(m_document, m_pipeline, *m_tools);
    addDock(QStringLiteral("mixDock"), tr("Mix"), m_mixPanel, Qt::BottomDockWidgetArea, true);
    auto* history = new QUndoView(&m_document.undoStack());
    history->setObjectName(QStringLiteral("historyList"));
    history->setEmptyLabel(tr("Start"));
    history->setFrameShape(QFrame::NoFrame);
    history->setAccessibleName(tr("History"));
    history->setToolTip(tr("Every change you made. Click one to go back to it."));
    addDock(QStringLiteral("historyDock"), tr("History"), history, Qt::BottomDockWidgetArea, false);
    auto* jobs = new JobsPanel(m_runner);
    connect(jobs, &JobsPanel::cancelWanted, this, [this](JobKind kind) {
        if (kind == JobKind::Texton)
            m_pipeline.cancelTexton(); // what is shown of it goes, too
        else if (kind == JobKind::Mix)
            m_pipeline.cancelMix();
        else
            m_runner.cancel(kind);
    });
    addDock(QStringLiteral("jobsDock"), tr("Jobs"), jobs, Qt::BottomDockWidgetArea, false);
}

void MainWindow::arrangeDocks() {
    const auto dock = [this](const char* id) { return m_docks.at(QLatin1String(id)); };
    for (const auto& [id, each] : m_docks) {
        each->setFloating(false);
        each->show();
    }
    addDockWidget(Qt::LeftDockWidgetArea, dock("exemplarDock"));
    addDockWidget(Qt::RightDockWidgetArea, dock("textonDock"));
    splitDockWidget(dock("textonDock"), dock("noiseDock"), Qt::Vertical);
    for (const char* id : {"spectrumDock", "histogramDock", "mixDock", "historyDock", "jobsDock"})
        addDockWidget(Qt::BottomDockWidgetArea, dock(id));
    for (const char* id : {"histogramDock", "mixDock", "historyDock", "jobsDock"})
        tabifyDockWidget(dock("spectrumDock"), dock(id));
    dock("spectrumDock")->raise();
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    resizeDocks({dock("exemplarDock"), dock("textonDock")},
                {kLeftWidth, kRightWidth},
                Qt::Horizontal);
    resizeDocks({dock("spectrumDock")}, {kBottomHeight}, Qt::Vertical);
    resizeDocks({dock("textonDock"), dock("noiseDock")},
                {kTextonHeight, kNoiseHeight},
                Qt::Vertical);
}

void MainWindow::resetLayout() {
    m_hiddenDocks.clear();
    arrangeDocks();
}

void MainWindow::toggleDocks() {
    if (!m_hiddenDocks.empty()) {
        for (const auto& [dock, visible] : m_hiddenDocks)
            dock->setVisible(visible);
        m_hiddenDocks.clear();
        return;
    }
    for (const auto& [id, dock] : m_docks) {
        m_hiddenDocks[dock] = dock->toggleViewAction()->isChecked();
        dock->hide();
    }
    m_views->views().front()->setFocus();
}

void MainWindow::focusNextPart() {
    std::vector<QWidget*> parts{m_views};
    for (const char* id : kDockOrder) {
        QDockWidget* dock = m_docks.at(QLatin1String(id));
        if (dock->isVisible() && !dock->visibleRegion().isEmpty())
            parts.push_back(dock->widget());
    }
    const QWidget* focused = QApplication::focusWidget();
    std::size_t now = parts.size() - 1;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i] == focused || (focused != nullptr && parts[i]->isAncestorOf(focused)))
            now = i;
    }
    // A panel itself takes no focus: its first control does. Some have none.
    for (std::size_t step = 1; step <= parts.size(); ++step) {
        QWidget* part = parts[(now + step) % parts.size()];
        QList<QWidget*> candidates = part->findChildren<QWidget*>();
        candidates.prepend(part);
        for (QWidget* candidate : candidates) {
            if (candidate->isVisible() && candidate->isEnabled() &&
                candidate->focusProxy() == nullptr &&
                (candidate->focusPolicy() & Qt::TabFocus) == Qt::TabFocus) {
                candidate->setFocus(Qt::TabFocusReason);
                return;
            }
        }
    }
}

void MainWindow::createStatusBar() {
    m_probe = new QLabel;
    m_probe->setObjectName(QStringLiteral("probe"));
    m_zoom = new QLabel;
    m_probe->setToolTip(tr("Place and values of the pixel under the mouse."));
    m_zoom->setObjectName(QStringLiteral("zoom"));
    m_zoom->setToolTip(tr("How the pictures are shown: screen pixels for each pixel of the photo, "
                          "exposure, channel."));
    m_error = new QLabel;
    m_error->setObjectName(QStringLiteral("errorSummary"));
    m_error->setToolTip(tr("How far the texton is from the photo; see the Texton panel."));
    m_renderer = new QLabel;
    m_renderer->setObjectName(QStringLiteral("renderer"));
    m_renderer->setToolTip(tr("What draws the noise."));
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(new JobsStatus(m_runner));
    statusBar()->addWidget(m_probe, 1);
    for (QLabel* label : {m_zoom, m_error, m_renderer})
        statusBar()->addPermanentWidget(label);
    connect(m_views, &ViewArea::probed, this, &MainWindow::showProbe);
    connect(m_views, &ViewArea::probeLeft, m_probe, &QLabel::clear);
    const auto showZoom = [this] {
        const ViewState& view = m_document.view();
        const QLocale locale;
        QStringList parts{tr("Zoom %1 %").arg(locale.toString(100.0 * view.zoom, 'f', 0))};
        if (view.exposure != 0.0)
            parts.append(tr("exposure %1%2")
                             .arg(view.exposure > 0.0 ? QStringLiteral("+") : QString(),
                                  locale.toString(view.exposure, 'f', 1)));
        if (view.channel)
            parts.append(tr("channel %1 only").arg(*view.channel + 1));
        m_zoom->setText(parts.join(QStringLiteral(", ")));
    };
    connect(&m_document, &ProjectDocument::viewChanged, this, showZoom);
    showZoom();
    connect(&m_pipeline, &Pipeline::textonChanged, this, [this] {
        const auto texton = m_pipeline.texton();
        m_error->setText(
            texton && texton->dial && texton->dial->floor > 0.0
                ? tr("Covariance error %1 \u00d7 the floor")
                      .arg(QLocale().toString(texton->dial->error / texton->dial->floor, 'f', 2))
                : QString());
    });
}

void MainWindow::showProbe(const ProbeInfo& probe) {
    const QLocale locale;
    const auto numbers = [&](const std::vector<double>& values) {
        QStringList texts;
        for (const double value : values)
            texts.append(locale.toString(value, 'f', 3));
        return texts.join(QLatin1Char(' '));
    };
    QString text = tr("x %1  y %2").arg(probe.x).arg(probe.y);
    if (!probe.encoded.empty())
        text += QStringLiteral("    ") + tr("sRGB %1").arg(numbers(probe.encoded)) +
                QStringLiteral("    ") + tr("linear %1").arg(numbers(probe.linear));
    if (!probe.hex.isEmpty())
        text += QStringLiteral("    ") + probe.hex;
    m_probe->setText(text);
}

void MainWindow::showTitle() {
    setWindowTitle(m_document.title() + QStringLiteral("[*]"));
    setWindowModified(m_document.isModified());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const auto later = [this](int ms, Closing closing) {
        QTimer::singleShot(ms, this, [this, closing] {
            m_closing = closing;
            close();
        });
    };
    if (m_runner.isBusy(JobKind::Save)) { // it ends in a moment
        event->ignore();
        later(kSaveMs, m_closing);
        return;
    }
    if (m_closing == Closing::No && m_document.isModified()) {
        event->ignore();
        m_files->whenSafe([later] { later(0, Closing::NothingToSave); });
        return;
    }
    if (m_closing != Closing::NothingToExport && m_runner.isBusy(JobKind::Export)) {
        event->ignore();
        askAboutExport();
        return;
    }
    if (m_hiddenDocks.empty())
        m_settings.setWindow(saveGeometry(), saveState(kStateVersion));
    m_runner.cancelAll();
    event->accept();
}

void MainWindow::sayOutOfMemory() {
    m_messages->show(MessageBar::Kind::Warning,
                     tr("That did not work: %1").arg(JobRunner::outOfMemory()));
}

void MainWindow::askAboutExport() {
    auto* question = new QMessageBox(QMessageBox::Question,
                                     tr("Stop the export?"),
                                     tr("An export is still being written."),
                                     QMessageBox::Cancel,
                                     this);
    question->setObjectName(QStringLiteral("exportQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->addButton(tr("Stop it and close"), QMessageBox::AcceptRole);
    connect(question, &QMessageBox::finished, this, [this, question](int) {
        const bool stop =
            question->buttonRole(question->clickedButton()) == QMessageBox::AcceptRole;
        m_closing = stop ? Closing::NothingToExport : Closing::No;
        if (stop)
            close();
    });
    question->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (FileController::canOpen(*event->mimeData()))
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (m_files->openMime(*event->mimeData()))
        event->acceptProposedAction();
}

} // namespace txn::app
