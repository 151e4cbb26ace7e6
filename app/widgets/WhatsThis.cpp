// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/WhatsThis.h"

#include <QWidget>

namespace txn::app {

void explainByToolTips(QWidget& root) {
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        if (widget->whatsThis().isEmpty() && !widget->toolTip().isEmpty())
            widget->setWhatsThis(widget->toolTip());
    }
}

} // namespace txn::app
