// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/ChoiceRow.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace txn::app {

ChoiceRow::ChoiceRow(const QString& label, const QStringList& choices, QWidget* parent)
    : QWidget(parent), m_box(new QComboBox) {
    auto* text = new QLabel(label);
    text->setBuddy(m_box);
    m_box->addItems(choices);
    m_box->setAccessibleName(label);
    // The wheel scrolls the panel; it changes a choice only once that was asked for.
    m_box->setFocusPolicy(Qt::StrongFocus);
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_box->setMinimumContentsLength(8);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(text, 2);
    row->addWidget(m_box, 3);
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
