// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/DecodeClient.h"

#include <sys/types.h>

namespace txn {

/// A running `texton-decode`, which ends with this value. Move-only; one thread at a time. Internal
/// to core/image.
class DecoderProcess {
  public:
    /// Starts the program that lies beside this one or, where programs are installed, in the folder
    /// of their helpers. Errors: NotFound; Unreadable where the system will not start it.
    [[nodiscard]] static Result<DecoderProcess> start();
    DecoderProcess(DecoderProcess&& other) noexcept;
    DecoderProcess& operator=(DecoderProcess&& other) noexcept;
    DecoderProcess(const DecoderProcess&) = delete;
    DecoderProcess& operator=(const DecoderProcess&) = delete;
    ~DecoderProcess();

    /// Waits until it is there, which start() does not. False where it has died.
    [[nodiscard]] bool becomesReady();
    [[nodiscard]] DecodeAnswer
    decode(const FileBytes& file, const std::filesystem::path& name, const LoadOptions& options);

  private:
    DecoderProcess(pid_t process, DecoderConnection connection)
        : m_process(process), m_connection(std::move(connection)) {}

    pid_t m_process = -1;
    DecoderConnection m_connection;
    bool m_ready = false;
};

} // namespace txn
