// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/Mailbox.h"

#include "app/threads/HandOver.h"

#include <QCoreApplication>
#include <QEvent>
#include <memory>

namespace txn::app {
namespace {

struct Letter final : QEvent {
    explicit Letter(std::function<void()> content) : QEvent(User), work(std::move(content)) {}
    std::function<void()> work;
};

} // namespace

void Mailbox::post(std::function<void()> work) {
    auto letter = std::make_unique<Letter>(std::move(work));
    HandOver::give();
    QCoreApplication::postEvent(this, letter.release());
}

void Mailbox::customEvent(QEvent* event) {
    HandOver::take();
    static_cast<Letter*>(event)->work();
}

} // namespace txn::app
