// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/ChoiceRow.h"

#include "app/widgets/RowLabel.h"

#include <QComboBox>
#include <QHBoxLayout>

namespace txn::app {

ChoiceRow::ChoiceRow(const QString& label, const QStringList& choices, QWidget* parent)
    : QWidget(parent), m_box(new QComboBox) {
    m_box->addItems(choices);
    m_box->setAccessibleName(label);
    // The wheel scrolls the panel; it changes a choice only once that was asked for.
    m_box->setFocusPolicy(Qt::StrongFocus);
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_box->setMinimumContentsLength(8);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(new RowLabel(label, m_box));
    row->addWidget(m_box, 1);
    setFocusProxy(m_box);
    connect(m_box, &QComboBox::activated, this, &ChoiceRow::chosen);
}

int ChoiceRow::current() const {
    return m_box->currentIndex();
}

void ChoiceRow::setCurrent(int index) {
    m_box->setCurrentIndex(index);
}

} // namespace txn::app
