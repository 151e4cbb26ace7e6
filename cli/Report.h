// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <thread>

namespace txn::cli {

/// Wall time since it was made or last asked.
class Stopwatch {
  public:
    double lap();

  private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// A progress bar on standard error: only on a terminal, only for work that takes over a second,
/// gone when the object is.
class ProgressBar {
  public:
    explicit ProgressBar(std::string label);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// share: 0 to 1.
    void update(double share);

  private:
    std::string m_label;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    bool m_terminal;
    int m_shownPercent = -1;
};

/// "LABEL ... N s" on standard error for work that cannot tell how far it is: only on a terminal,
/// only after a second, gone when the object is.
class BusySign {
  public:
    explicit BusySign(std::string label);
    ~BusySign();
    BusySign(const BusySign&) = delete;
    BusySign& operator=(const BusySign&) = delete;

  private:
    std::jthread m_thread;
};

/// One JSON object on standard output.
void printJson(const nlohmann::ordered_json& json);
/// "wrote PATH", a line each, on standard output.
void printWritten(std::span<const std::filesystem::path> paths);

/// 1234.5 as "1234.5", 0.1234 as "0.1234": four significant digits.
[[nodiscard]] std::string shortNumber(double value);

/// In one sentence, why the relative model error cannot be small.
inline constexpr const char* kWhyModelErrorStays =
    "The relative model error stays near 0.46 even for a perfect texton, because it compares\n"
    "with one photograph, in which every wave's strength is random.";

} // namespace txn::cli
