// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

namespace txn {

/// Read end of a shared "please stop" flag. A default token never cancels. Thread-safe.
class CancelToken {
  public:
    CancelToken() = default;
    bool cancelled() const { return m_flag && m_flag->load(std::memory_order_relaxed); }

  private:
    friend class CancelSource;
    explicit CancelToken(std::shared_ptr<const std::atomic<bool>> flag) : m_flag(std::move(flag)) {}
    std::shared_ptr<const std::atomic<bool>> m_flag;
};

/// Write end. cancel() may be called from any thread and from a signal handler.
class CancelSource {
  public:
    CancelSource() : m_flag(std::make_shared<std::atomic<bool>>(false)) {}
    void cancel() noexcept { m_flag->store(true, std::memory_order_relaxed); }
    CancelToken token() const { return CancelToken(m_flag); }

  private:
    std::shared_ptr<std::atomic<bool>> m_flag;
};

} // namespace txn
