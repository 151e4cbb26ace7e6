// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace txn::cli {

/// Standard error for the program alone. Some decoders print there by themselves ("libpng error:
/// ..."); from hushLibraries() on that goes nowhere, and what users read is our one line.
void hushLibraries();

/// Writes text as it is, and at once.
void printError(const std::string& text);

/// "texton: stopped; nothing was written". May be called from a signal handler.
void printStopped() noexcept;

/// Whether somebody is looking.
[[nodiscard]] bool errorIsTerminal();

} // namespace txn::cli
