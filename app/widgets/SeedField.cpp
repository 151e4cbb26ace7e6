// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/SeedField.h"

#include "app/look/Theme.h"
#include "app/widgets/RowLabel.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QRandomGenerator>
#include <QToolButton>

namespace txn::app {
namespace {

constexpr quint32 kNiceSeeds = 10000; ///< dice give numbers that can be told over the phone

} // namespace

SeedField::SeedField(const QString& label, Lock lock, QWidget* parent)
    : QWidget(parent), m_field(new QLineEdit), m_dice(new QToolButton) {
    m_field->setObjectName(QStringLiteral("field"));
    m_field->setAccessibleName(label);
    m_field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_field->setMaxLength(10);
    m_dice->setObjectName(QStringLiteral("dice"));
    m_dice->setIcon(themeIcon(QStringLiteral("dice")));
    m_dice->setAccessibleName(tr("Roll the dice"));
    m_dice->setToolTip(tr("Another random result."));
    m_dice->setFocusPolicy(Qt::StrongFocus);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(new RowLabel(label, m_field));
    row->addSpacing(4);
    row->addWidget(m_field, 1);
    row->addWidget(m_dice);
    if (lock == Lock::Shown) {
        m_lock = new QToolButton;
        m_lock->setObjectName(QStringLiteral("lock"));
        m_lock->setCheckable(true);
        m_lock->setAccessibleName(tr("Keep this seed"));
        m_lock->setToolTip(tr("Keeps this number when new seeds are rolled."));
        m_lock->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(m_lock);
        connect(m_lock, &QToolButton::clicked, this, &SeedField::lockEdited);
        setLocked(false);
    }
    setFocusProxy(m_field);
    connect(m_field, &QLineEdit::editingFinished, this, [this] {
        bool ok = false;
        const quint32 typed = m_field->text().trimmed().toUInt(&ok);
        if (ok && typed != m_seed) {
            m_seed = typed;
            emit seedEdited(typed, Gesture{});
        }
        m_field->setText(QString::number(m_seed));
    });
    connect(m_dice, &QToolButton::clicked, this, [this] {
        setSeed(QRandomGenerator::global()->bounded(kNiceSeeds));
        emit seedEdited(m_seed, Gesture{});
    });
}

quint32 SeedField::seed() const {
    return m_seed;
}

void SeedField::setSeed(quint32 seed) {
    m_seed = seed;
    m_field->setText(QString::number(seed));
}

void SeedField::setLocked(bool locked) {
    if (m_lock == nullptr)
        return;
    m_lock->setChecked(locked);
    m_lock->setIcon(themeIcon(locked ? QStringLiteral("lock") : QStringLiteral("unlock")));
    m_dice->setEnabled(!locked);
}

} // namespace txn::app
