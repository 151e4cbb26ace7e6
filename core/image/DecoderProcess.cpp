// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecoderProcess.h"

#include "core/base/OutputFiles.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>

extern char** environ; // NOLINT(readability-identifier-naming): the system's

namespace txn {
namespace {

namespace fs = std::filesystem;

constexpr int kSocketOfDecoder = 3;
constexpr int kPipeOfDecoder = 4;

Result<fs::path> decoderProgram() {
    std::error_code ec;
    const fs::path here = fs::read_symlink("/proc/self/exe", ec).parent_path();
    // Beside this program, beside the tests, and as installed.
    for (const char* folder : {".", "../bin", "../" TXN_HELPER_DIR}) {
        const fs::path program = here / folder / "texton-decode";
        if (::access(program.c_str(), X_OK) == 0)
            return program;
    }
    return Error{ErrorCode::NotFound,
                 "cannot read pictures: the program texton-decode, a part of Texton Studio, is "
                 "missing; install Texton Studio again"};
}

/// What posix_spawn needs to be told, freed in the end.
class SpawnPlan {
  public:
    SpawnPlan(int socket, int pipe) {
        ::posix_spawn_file_actions_init(&m_actions);
        ::posix_spawn_file_actions_adddup2(&m_actions, socket, kSocketOfDecoder);
        ::posix_spawn_file_actions_adddup2(&m_actions, pipe, kPipeOfDecoder);
        ::posix_spawn_file_actions_addclosefrom_np(&m_actions, kPipeOfDecoder + 1);
        ::posix_spawnattr_init(&m_attributes);
        sigset_t none;
        sigset_t all;
        sigemptyset(&none);
        sigfillset(&all);
        ::posix_spawnattr_setsigmask(&m_attributes, &none);
        ::posix_spawnattr_setsigdefault(&m_attributes, &all);
        // Out of the terminal's group: Ctrl-C is for the program, which then ends its decoder.
        ::posix_spawnattr_setpgroup(&m_attributes, 0);
        ::posix_spawnattr_setflags(&m_attributes,
                                   POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                       POSIX_SPAWN_SETPGROUP);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
    ~SpawnPlan() {
        ::posix_spawn_file_actions_destroy(&m_actions);
        ::posix_spawnattr_destroy(&m_attributes);
    }

    /// 0 or the errno.
    int spawn(pid_t& process, const fs::path& program) const {
        std::string name = program.string();
        const std::array<char*, 2> arguments{name.data(), nullptr};
        return ::posix_spawn(&process,
                             program.c_str(),
                             &m_actions,
                             &m_attributes,
                             arguments.data(),
                             environ);
    }

  private:
    posix_spawn_file_actions_t m_actions{};
    posix_spawnattr_t m_attributes{};
};

struct Ends {
    DecoderConnection ours;
    FileDescriptor socketOfDecoder;
    FileDescriptor pipeOfDecoder;
};

/// Clear of the numbers that they get in the decoder, lest one be put over the other.
FileDescriptor high(const FileDescriptor& file) {
    return FileDescriptor(::fcntl(file.get(), F_DUPFD_CLOEXEC, kPipeOfDecoder + 1));
}

/// Nothing where the system gives no more; errno says why.
std::optional<Ends> makeEnds() {
    constexpr int kPipeBytes = 1 << 20; // as much as everyone may have: fewer changes of process
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0)
        return std::nullopt;
    FileDescriptor ourSocket(sockets[0]);
    const FileDescriptor theirSocket(sockets[1]);
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
        return std::nullopt;
    FileDescriptor ourPipe(pipe[0]);
    const FileDescriptor theirPipe(pipe[1]);
    ::fcntl(ourPipe.get(), F_SETPIPE_SZ, kPipeBytes);
    Ends ends{.ours = {DecodeChannel(std::move(ourSocket)), std::move(ourPipe)},
              .socketOfDecoder = high(theirSocket),
              .pipeOfDecoder = high(theirPipe)};
    if (::fcntl(ends.ours.pictures.get(), F_SETFL, O_NONBLOCK) != 0 || !ends.socketOfDecoder ||
        !ends.pipeOfDecoder)
        return std::nullopt;
    return ends;
}

} // namespace

Result<DecoderProcess> DecoderProcess::start() {
    const auto program = decoderProgram();
    if (!program)
        return program.error();
    const auto failed = [&](int code) {
        return Error{ErrorCode::Unreadable,
                     "cannot read pictures: the system does not start " + quoted(*program) + ": " +
                         std::generic_category().message(code)};
    };
    auto ends = makeEnds();
    if (!ends)
        return failed(errno);
    const SpawnPlan plan(ends->socketOfDecoder.get(), ends->pipeOfDecoder.get());
    pid_t process = -1;
    if (const int code = plan.spawn(process, *program); code != 0)
        return failed(code);
    return DecoderProcess(process, std::move(ends->ours));
}

DecoderProcess::DecoderProcess(DecoderProcess&& other) noexcept
    : m_process(std::exchange(other.m_process, -1)), m_connection(std::move(other.m_connection)),
      m_ready(other.m_ready) {}

DecoderProcess& DecoderProcess::operator=(DecoderProcess&& other) noexcept {
    std::swap(m_process, other.m_process);
    std::swap(m_connection, other.m_connection);
    std::swap(m_ready, other.m_ready);
    return *this;
}

DecoderProcess::~DecoderProcess() {
    if (m_process <= 0)
        return;
    ::kill(m_process, SIGKILL);
    while (::waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
    }
}

bool DecoderProcess::becomesReady() {
    m_ready = m_ready || waitUntilReady(m_connection);
    return m_ready;
}

DecodeAnswer
DecoderProcess::decode(const FileBytes& file, const fs::path& name, const LoadOptions& options) {
    if (!becomesReady())
        return DecodeFailure::Died;
    return askDecoder(m_connection, file, name, options);
}

} // namespace txn
