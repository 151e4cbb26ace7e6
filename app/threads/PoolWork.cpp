// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/PoolWork.h"

#include "app/threads/HandOver.h"

#include <QRunnable>
#include <QThreadPool>
#include <memory>
#include <utility>

namespace txn::app {
namespace {

class PoolWork final : public QRunnable {
  public:
    explicit PoolWork(std::function<void()> work) : m_work(std::move(work)) {}
    void run() override {
        HandOver::take();
        std::exchange(m_work, nullptr)(); // and lets go of what it holds
        HandOver::give();
    }

  private:
    std::function<void()> m_work;
};

} // namespace

void startOn(QThreadPool& pool, std::function<void()> work, int priority) {
    auto owned = std::make_unique<PoolWork>(std::move(work));
    HandOver::give();
    pool.start(owned.release(), priority); // which deletes it
}

void waitFor(QThreadPool& pool) {
    pool.waitForDone();
    HandOver::take();
}

} // namespace txn::app
