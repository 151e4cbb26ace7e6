// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace txn {

/// From now on this process and its threads can start no program or process, reach no network and
/// no other process, and write, rename or delete no file; such calls fail with EPERM. Where the
/// system knows no such filters, nothing changes. For ever; before the first thread is started.
void forbidHarmfulSystemCalls();

} // namespace txn
