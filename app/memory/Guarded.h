// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <functional>
#include <new>

namespace txn::app {

/// An application in which running out of memory ends the handling of an event, not the program.
/// What the handler has not come to is done by the next change. Jobs have a guard of their own.
template <class Application>
class Guarded final : public Application {
  public:
    using Application::Application;

    /// Says so; must need little memory itself.
    std::function<void()> outOfMemory;

    bool notify(QObject* receiver, QEvent* event) override {
        try {
            return Application::notify(receiver, event);
        } catch (const std::bad_alloc&) {
            if (outOfMemory)
                outOfMemory();
            return false;
        }
    }
};

} // namespace txn::app
