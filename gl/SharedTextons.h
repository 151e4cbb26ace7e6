// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texton/Texton.h"

#include <memory>
#include <span>
#include <vector>

namespace txn {

/// A texton, or those of a mixture, that others may hold as well: a list either way. A regular
/// value; equal where the same list is held.
class SharedTextons {
  public:
    SharedTextons() = default;
    explicit SharedTextons(std::shared_ptr<const Texton> texton)
        : m_list(texton.get(), texton ? 1 : 0), m_owner(std::move(texton)) {}
    explicit SharedTextons(std::shared_ptr<const std::vector<Texton>> textons)
        : m_list(textons ? std::span<const Texton>(*textons) : std::span<const Texton>()),
          m_owner(std::move(textons)) {}

    std::span<const Texton> list() const { return m_list; }
    bool empty() const { return m_list.empty(); }
    bool operator==(const SharedTextons& other) const { return m_owner == other.m_owner; }

  private:
    std::span<const Texton> m_list;
    std::shared_ptr<const void> m_owner;
};

} // namespace txn
