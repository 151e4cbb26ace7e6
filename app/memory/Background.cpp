// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/memory/Background.h"

#include <QCoreApplication>
#include <QThreadPool>

namespace txn::app {

void inBackground(std::function<void()> work) {
    if (QCoreApplication::instance() == nullptr || QCoreApplication::closingDown()) {
        work();
        return;
    }
    QThreadPool::globalInstance()->start(std::move(work));
}

} // namespace txn::app
