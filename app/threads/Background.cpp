// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/Background.h"

#include "app/threads/PoolWork.h"

#include <QCoreApplication>
#include <QThreadPool>

namespace txn::app {

void inBackground(std::function<void()> work) {
    if (QCoreApplication::instance() == nullptr || QCoreApplication::closingDown()) {
        work();
        return;
    }
    startOn(*QThreadPool::globalInstance(), std::move(work));
}

} // namespace txn::app
