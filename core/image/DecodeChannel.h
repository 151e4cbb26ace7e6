// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/FileDescriptor.h"
#include "core/image/DecodeMessages.h"

#include <chrono>

namespace txn {

/// Waits until there is something to read or the other end is closed; false when the deadline,
/// where there is one, is over.
[[nodiscard]] bool waitForReading(int fd, const std::chrono::steady_clock::time_point* deadline);

/// The socket between a program and its image decoder: whole messages, each with a descriptor or
/// none. Internal to core/image. Not thread-safe.
class DecodeChannel {
  public:
    using Deadline = std::chrono::steady_clock::time_point;
    enum class Got { Whole, Nothing, Closed };

    explicit DecodeChannel(FileDescriptor socket) : m_socket(std::move(socket)) {}

    /// False where nobody listens any more.
    [[nodiscard]] bool send(const Message& message, int descriptor = -1) const;

    struct Received {
        Got got = Got::Closed;
        Message message;
        FileDescriptor descriptor;
    };
    /// Waits for a message until the deadline, where there is one: Nothing when it is over. A
    /// message that is too long or brings more than one descriptor counts as Closed.
    [[nodiscard]] Received receive(const Deadline* deadline = nullptr) const;

  private:
    FileDescriptor m_socket;
};

} // namespace txn
