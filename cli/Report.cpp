// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Report.h"

#include "cli/Console.h"

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>

namespace txn::cli {

double Stopwatch::lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - m_start).count();
    m_start = now;
    return seconds;
}

ProgressBar::ProgressBar(std::string label)
    : m_label(std::move(label)), m_terminal(errorIsTerminal()) {}

ProgressBar::~ProgressBar() {
    if (m_shownPercent >= 0)
        printError("\r\033[K");
}

void ProgressBar::update(double share) {
    constexpr int kWidth = 30;
    if (!m_terminal || std::chrono::steady_clock::now() - m_start < std::chrono::seconds(1))
        return;
    const int percent = std::clamp(static_cast<int>(share * 100.0), 0, 100);
    if (percent == m_shownPercent)
        return;
    m_shownPercent = percent;
    const auto filled = static_cast<std::size_t>(percent * kWidth / 100);
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '-');
    printError("\r" + m_label + " [" + bar + "] " + std::to_string(percent) + " %");
}

BusySign::BusySign(std::string label) {
    if (!errorIsTerminal())
        return;
    m_thread = std::jthread([label = std::move(label)](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any wake;
        std::unique_lock lock(mutex);
        const auto second = std::chrono::seconds(1);
        for (int seconds = 1;
             !wake.wait_for(lock, stop, second, [&] { return stop.stop_requested(); });
             ++seconds)
            printError("\r" + label + " ... " + std::to_string(seconds) + " s");
        printError("\r\033[K");
    });
}

BusySign::~BusySign() = default;

void printJson(const nlohmann::ordered_json& json) {
    // File names may hold bytes that are not UTF-8.
    std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void printWritten(std::span<const std::filesystem::path> paths) {
    for (const auto& path : paths)
        std::cout << "wrote " << path.string() << '\n';
}

std::string shortNumber(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g", value);
    return buffer;
}

} // namespace txn::cli
