// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

namespace txn::app {

/// The value of a number or sum such as "2*64+1", with + - * / and parentheses, comma or point for
/// decimals; nothing where it is none or not finite.
[[nodiscard]] std::optional<double> evaluateSum(const QString& text);

} // namespace txn::app
