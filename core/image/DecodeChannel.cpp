// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeChannel.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

namespace txn {
namespace {

/// Room for the control message of one descriptor.
struct alignas(cmsghdr) Control {
    std::array<char, CMSG_SPACE(sizeof(int))> bytes{};
};

/// Milliseconds until then, rounded up; -1, for ever, without a deadline.
int waitMs(const DecodeChannel::Deadline* deadline) {
    if (deadline == nullptr)
        return -1;
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(*deadline - std::chrono::steady_clock::now());
    return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, INT_MAX));
}

} // namespace

bool waitForReading(int fd, const std::chrono::steady_clock::time_point* deadline) {
    pollfd waiting{fd, POLLIN, 0};
    int ready = 0;
    do {
        ready = ::poll(&waiting, 1, waitMs(deadline));
    } while (ready < 0 && errno == EINTR);
    return ready != 0;
}

bool DecodeChannel::send(const Message& message, int descriptor) const {
    iovec part{const_cast<std::uint8_t*>(message.data()), message.size()}; // sendmsg only reads
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    Control control;
    if (descriptor >= 0) {
        header.msg_control = control.bytes.data();
        header.msg_controllen = control.bytes.size();
        cmsghdr* first = CMSG_FIRSTHDR(&header);
        first->cmsg_level = SOL_SOCKET;
        first->cmsg_type = SCM_RIGHTS;
        first->cmsg_len = CMSG_LEN(sizeof(int));
        std::memcpy(CMSG_DATA(first), &descriptor, sizeof(int));
    }
    ssize_t sent = -1;
    do {
        sent = ::sendmsg(m_socket.get(), &header, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    return sent == static_cast<ssize_t>(message.size());
}

DecodeChannel::Received DecodeChannel::receive(const Deadline* deadline) const {
    Received received;
    if (!waitForReading(m_socket.get(), deadline)) {
        received.got = Got::Nothing;
        return received;
    }

    received.message.resize(kMaxMessageBytes);
    iovec part{received.message.data(), received.message.size()};
    Control control;
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    header.msg_control = control.bytes.data();
    header.msg_controllen = control.bytes.size();
    ssize_t length = -1;
    do {
        length = ::recvmsg(m_socket.get(), &header, MSG_CMSG_CLOEXEC);
    } while (length < 0 && errno == EINTR);
    if (length <= 0)
        return received;
    for (cmsghdr* extra = CMSG_FIRSTHDR(&header); extra != nullptr;
         extra = CMSG_NXTHDR(&header, extra)) {
        if (extra->cmsg_level != SOL_SOCKET || extra->cmsg_type != SCM_RIGHTS ||
            extra->cmsg_len != CMSG_LEN(sizeof(int)))
            continue;
        int descriptor = -1;
        std::memcpy(&descriptor, CMSG_DATA(extra), sizeof(int));
        received.descriptor = FileDescriptor(descriptor);
    }
    if ((header.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0)
        return received;
    received.message.resize(static_cast<std::size_t>(length));
    received.got = Got::Whole;
    return received;
}

} // namespace txn
