// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Application.h"

#include "app/MainWindow.h"
#include "app/files/Autosave.h"
#include "app/files/FileController.h"
#include "app/files/RecoveryDialog.h"
#include "app/look/Words.h"
#include "app/widgets/MessageBar.h"
#include "core/image/ImageIo.h"

#include <QStandardPaths>

namespace txn::app {
namespace {

const QString kFirstSample = QStringLiteral("rust");

} // namespace

Application::Application(Settings& settings, const QString& recoveryFolder)
    : m_settings(settings), m_recoveryFolder(recoveryFolder), m_pipeline(m_document, m_runner),
      m_autosave(std::make_unique<Autosave>(m_document, m_runner, recoveryFolder)),
      m_window(std::make_unique<MainWindow>(
          MainWindow::Parts{m_settings, m_document, m_runner, m_pipeline, m_noise})) {
    QObject::connect(m_autosave.get(),
                     &Autosave::failed,
                     m_window.get(),
                     [this](const QString& text) {
                         m_window->messages().show(MessageBar::Kind::Warning, text);
                     });
    // The helper takes a quarter of a second of a core to load its libraries, which the first
    // texton needs more. Whoever opens a picture before that starts it.
    QObject::connect(&m_pipeline, &Pipeline::textonChanged, m_window.get(), [this] {
        if (m_pipeline.texton() && m_pipeline.texton()->finished)
            startImageReading();
    });
}

Application::~Application() = default;

QString Application::standardRecoveryFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
           QStringLiteral("/recovery");
}

void Application::start(const QStringList& files) {
    if (!files.isEmpty()) {
        m_window->files().open(files);
        return;
    }
    if (!mayBeRecoverable(m_recoveryFolder)) {
        m_window->files().openSample(kFirstSample);
        return;
    }
    m_runner.submit(JobKind::Open,
                    MainWindow::tr("Looking for unsaved work"),
                    [this, folder = m_recoveryFolder](JobContext&) -> Delivery {
                        return [this, copies = findRecoverable(folder)] { offerRecovery(copies); };
                    });
}

void Application::offerRecovery(std::vector<RecoveredProject> copies) {
    if (copies.empty()) {
        m_window->files().openSample(kFirstSample);
        return;
    }
    auto* dialog = new RecoveryDialog(std::move(copies), m_window.get());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog,
                     &RecoveryDialog::recoverRequested,
                     m_window.get(),
                     [this](const RecoveredProject& copy) { recover(copy); });
    QObject::connect(dialog, &QDialog::rejected, m_window.get(), [this] {
        m_window->files().openSample(kFirstSample);
    });
    dialog->open();
}

void Application::recover(const RecoveredProject& copy) {
    m_runner.submit(JobKind::Open,
                    MainWindow::tr("Recovering %1").arg(copy.title),
                    [this, copy](JobContext&) -> Delivery {
                        auto saved = readRecovered(copy);
                        return [this, copy, saved = std::move(saved)] {
                            if (!saved) {
                                m_window->messages().show(MessageBar::Kind::Problem,
                                                          inWords(saved.error()));
                                return;
                            }
                            m_window->files().whenSafe([this, saved = *saved, copy] {
                                m_window->files().recover(saved, copy.originalPath);
                                m_autosave->adopt(copy);
                            });
                        };
                    });
}

} // namespace txn::app
