// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"

#include <QWidget>

class QLineEdit;
class QToolButton;

namespace txn::app {

/// A row with the number of a random result, dice for another one and, where wanted, a lock.
class SeedField : public QWidget {
    Q_OBJECT

  public:
    enum class Lock { None, Shown };
    explicit SeedField(const QString& label, Lock lock = Lock::Shown, QWidget* parent = nullptr);

    quint32 seed() const;
    /// Without telling anybody.
    void setSeed(quint32 seed);
    void setLocked(bool locked);

  signals:
    void seedEdited(quint32 seed, Gesture gesture);
    void lockEdited(bool locked);

  private:
    quint32 m_seed = 0;
    QLineEdit* m_field;
    QToolButton* m_dice;
    QToolButton* m_lock = nullptr;
};

} // namespace txn::app
