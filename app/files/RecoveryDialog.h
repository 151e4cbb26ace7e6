// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Autosave.h"

#include <QDialog>

class QLabel;
class QListWidget;

namespace txn::app {

/// Asks what to do with the copies of work that a crash left behind.
class RecoveryDialog : public QDialog {
    Q_OBJECT

  public:
    explicit RecoveryDialog(std::vector<RecoveredProject> copies, QWidget* parent = nullptr);

  signals:
    void recoverRequested(const RecoveredProject& copy);

  private:
    const RecoveredProject* current() const;
    void showCurrent();

    std::vector<RecoveredProject> m_copies;
    QListWidget* m_list;
    QLabel* m_preview;
};

} // namespace txn::app
