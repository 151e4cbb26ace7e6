// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/ValueSlider.h"

#include "app/widgets/RowLabel.h"
#include "app/widgets/SliderTrack.h"
#include "app/widgets/Sum.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace txn::app {
namespace {

constexpr int kFieldWidth = 64;

} // namespace

ValueSlider::ValueSlider(const QString& label, Range range, QWidget* parent)
    : QWidget(parent), m_range(std::move(range)), m_value(m_range.standard),
      m_track(new SliderTrack(*this)), m_field(new QLineEdit) {
    m_field->setFixedWidth(kFieldWidth);
    m_field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_field->setObjectName(QStringLiteral("field"));
    m_field->setAccessibleName(label);
    m_track->setObjectName(QStringLiteral("track"));
    m_track->setAccessibleName(label);
    m_field->installEventFilter(this);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(new RowLabel(label, m_field));
    row->addWidget(m_track, 1);
    row->addWidget(m_field);
    setFocusProxy(m_track);
    connect(m_field, &QLineEdit::editingFinished, this, &ValueSlider::takeTyped);
    showValue();
}

void ValueSlider::setValue(double value) {
    m_value = value;
    m_track->update();
    if (!m_field->hasFocus() || !m_field->isModified())
        showValue();
}

void ValueSlider::showValue() {
    QString text = QLocale().toString(m_value, 'f', m_range.decimals);
    if (!m_range.unit.isEmpty())
        text += QLatin1Char(' ') + m_range.unit;
    m_field->setText(text);
    m_field->setModified(false);
}

void ValueSlider::edit(double value, Gesture gesture) {
    const bool wider = m_range.typedLow < m_range.typedHigh;
    const double factor = std::pow(10.0, m_range.decimals);
    const double rounded = std::round(value * factor) / factor;
    const double allowed = std::clamp(rounded,
                                      wider ? m_range.typedLow : m_range.low,
                                      wider ? m_range.typedHigh : m_range.high);
    const bool changed = allowed != m_value;
    m_value = allowed;
    m_track->update();
    showValue();
    if (changed)
        emit valueEdited(allowed, gesture);
}

void ValueSlider::takeTyped() {
    if (!m_field->isModified())
        return;
    QString text = m_field->text().trimmed();
    if (!m_range.unit.isEmpty() && text.endsWith(m_range.unit))
        text.chop(m_range.unit.size());
    // In a number as it is shown, what parts thousands must not be taken for a decimal point.
    bool plain = false;
    const double shown = QLocale().toDouble(text.trimmed(), &plain);
    const auto value = plain ? std::optional(shown) : evaluateSum(text);
    if (value)
        edit(*value, Gesture::next());
    else
        showValue();
}

bool ValueSlider::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && m_field->isModified()) {
        showValue();
        m_field->selectAll();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace txn::app
