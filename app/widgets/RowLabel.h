// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <algorithm>

namespace txn::app {

/// The label at the start of a panel's row, as wide as those of the other rows, so that the
/// controls of a panel stand below each other. A text that does not fit makes its row wider, not
/// unreadable.
class RowLabel : public QLabel {
  public:
    static constexpr int kWidth = 112;

    RowLabel(const QString& text, QWidget* control) : QLabel(text) {
        setMinimumWidth(kWidth);
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
        setBuddy(control);
    }
    QSize sizeHint() const override {
        return {std::max(kWidth, QLabel::sizeHint().width()), QLabel::sizeHint().height()};
    }
};

} // namespace txn::app
