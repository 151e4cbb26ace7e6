// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace txn::app {

/// Runs work on some other thread, soon; at once where the program is about to end. For what takes
/// its time and of which nobody waits for the end.
void inBackground(std::function<void()> work);

/// The same value, which is destroyed in the background, whoever lets it go: giving back half a
/// gigabyte to the system takes longer than the interface may stand still.
template <class T>
[[nodiscard]] std::shared_ptr<const T> freedInBackground(std::shared_ptr<const T> value) {
    const T* raw = value.get();
    return std::shared_ptr<const T>(raw, [held = std::move(value)](const T*) mutable {
        inBackground([last = std::move(held)]() mutable { last.reset(); });
    });
}

} // namespace txn::app
