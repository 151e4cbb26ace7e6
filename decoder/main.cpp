// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeServer.h"

#include <cstdio>

/// Decodes pictures for Texton Studio's programs, apart from them, so that one that crashes a
/// decoder, or takes it over, does them no harm.
int main() {
    constexpr int kSocket = 3;
    constexpr int kPipe = 4;
    if (txn::serveDecoding(txn::FileDescriptor(kSocket), txn::FileDescriptor(kPipe)))
        return 0;
    std::fputs("texton-decode reads pictures for Texton Studio and is started by it\n", stderr);
    return 2;
}
