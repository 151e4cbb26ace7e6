// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/SystemCallFilter.h"

#include <cerrno>
#include <fcntl.h>
#include <initializer_list>
#include <memory>
#include <sched.h>
#include <seccomp.h>
#include <sys/types.h>
#include <unistd.h>

namespace txn {
namespace {

/// A list of what is forbidden, not of what is allowed: decoders and the C library change what
/// they call from version to version, and none needs these.
constexpr auto kForbidden = {
    // programs, processes and threads of others
    SCMP_SYS(execve),
    SCMP_SYS(execveat),
    SCMP_SYS(fork),
    SCMP_SYS(vfork),
    SCMP_SYS(ptrace),
    SCMP_SYS(process_vm_readv),
    SCMP_SYS(process_vm_writev),
    SCMP_SYS(kill),
    SCMP_SYS(tkill),
    SCMP_SYS(pidfd_open),
    SCMP_SYS(pidfd_send_signal),
    SCMP_SYS(setsid),
    SCMP_SYS(setpgid),
    // the network and other programs' sockets
    SCMP_SYS(socket),
    SCMP_SYS(socketpair),
    SCMP_SYS(connect),
    SCMP_SYS(bind),
    SCMP_SYS(listen),
    SCMP_SYS(accept),
    SCMP_SYS(accept4),
    // files and folders
    SCMP_SYS(creat),
    SCMP_SYS(truncate),
    SCMP_SYS(unlink),
    SCMP_SYS(unlinkat),
    SCMP_SYS(rename),
    SCMP_SYS(renameat),
    SCMP_SYS(renameat2),
    SCMP_SYS(link),
    SCMP_SYS(linkat),
    SCMP_SYS(symlink),
    SCMP_SYS(symlinkat),
    SCMP_SYS(mkdir),
    SCMP_SYS(mkdirat),
    SCMP_SYS(rmdir),
    SCMP_SYS(mknod),
    SCMP_SYS(mknodat),
    SCMP_SYS(chmod),
    SCMP_SYS(fchmod),
    SCMP_SYS(fchmodat),
    SCMP_SYS(chown),
    SCMP_SYS(fchown),
    SCMP_SYS(lchown),
    SCMP_SYS(fchownat),
    SCMP_SYS(utimensat),
    SCMP_SYS(setxattr),
    SCMP_SYS(lsetxattr),
    SCMP_SYS(fsetxattr),
    SCMP_SYS(open_by_handle_at),
    // the system
    SCMP_SYS(mount),
    SCMP_SYS(umount2),
    SCMP_SYS(pivot_root),
    SCMP_SYS(chroot),
    SCMP_SYS(unshare),
    SCMP_SYS(setns),
    SCMP_SYS(bpf),
    SCMP_SYS(perf_event_open),
    SCMP_SYS(userfaultfd),
    SCMP_SYS(keyctl),
    SCMP_SYS(add_key),
    SCMP_SYS(request_key),
    SCMP_SYS(io_uring_setup),
    SCMP_SYS(init_module),
    SCMP_SYS(finit_module),
    SCMP_SYS(kexec_load),
    SCMP_SYS(reboot)};

/// Opening files for anything but reading.
void forbidWriting(scmp_filter_ctx filter, int call, unsigned flagsArgument) {
    for (const int flag : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC}) {
        const auto bits = static_cast<scmp_datum_t>(flag);
        seccomp_rule_add(filter,
                         SCMP_ACT_ERRNO(EPERM),
                         call,
                         1,
                         SCMP_CMP(flagsArgument, SCMP_CMP_MASKED_EQ, bits, bits));
    }
}

} // namespace

void forbidHarmfulSystemCalls() {
    const std::unique_ptr<void, void (*)(scmp_filter_ctx)> filter(seccomp_init(SCMP_ACT_ALLOW),
                                                                  seccomp_release);
    if (!filter)
        return;
    for (const int call : kForbidden)
        seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(EPERM), call, 0);
    forbidWriting(filter.get(), SCMP_SYS(open), 1);
    forbidWriting(filter.get(), SCMP_SYS(openat), 2);
    // Threads only. What filters cannot look into does not exist; the C library then takes the old
    // way.
    seccomp_rule_add(filter.get(),
                     SCMP_ACT_ERRNO(EPERM),
                     SCMP_SYS(clone),
                     1,
                     SCMP_CMP(0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
    seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
    seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(openat2), 0);
    // abort() signals its own thread.
    seccomp_rule_add(filter.get(),
                     SCMP_ACT_ERRNO(EPERM),
                     SCMP_SYS(tgkill),
                     1,
                     SCMP_CMP(0, SCMP_CMP_NE, static_cast<scmp_datum_t>(::getpid())));
    seccomp_load(filter.get());
}

} // namespace txn
