// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

namespace txn::app {

/// One step of the pipeline: the newest value, what it was made for, and what is asked for now.
template <class Key, class Value>
struct Stage {
    std::optional<Key> wanted;
    std::optional<Key> made; ///< what value answers
    std::shared_ptr<const Value> value;

    bool isStale() const { return wanted != made; }
    /// True once for every new key: then a job has to be started.
    bool want(std::optional<Key> key) {
        if (wanted == key)
            return false;
        wanted = std::move(key);
        return wanted.has_value();
    }
    void set(const Key& key, std::shared_ptr<const Value> newValue) {
        made = key;
        value = std::move(newValue);
    }
    void clear() { *this = {}; }
};

} // namespace txn::app
