// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

namespace txn::app {

/// Work for the thread on which it lives, from any other.
class Mailbox final : public QObject {
  public:
    /// Runs soon on the mailbox's thread, in the order of posting; never if the mailbox has gone by
    /// then. Any thread, while the mailbox lives.
    void post(std::function<void()> work);

  protected:
    void customEvent(QEvent* event) override;
};

} // namespace txn::app
