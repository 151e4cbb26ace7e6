// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Parse.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace txn::cli {
namespace {

/// Numbers of one kind between separators, and nothing else.
template <class Number = std::int64_t>
std::optional<std::vector<Number>> numbers(const std::string& text, char separator) {
    std::vector<Number> result;
    const char* at = text.data();
    const char* end = at + text.size();
    while (true) {
        Number value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc())
            return std::nullopt;
        result.push_back(value);
        if (next == end)
            return result;
        if (*next != separator)
            return std::nullopt;
        at = next + 1;
    }
}

/// Wider pictures are beyond what file formats and their readers take.
constexpr std::int64_t kLargestSide = 1 << 20;

bool isSide(std::int64_t value) {
    return value >= 1 && value <= kLargestSide;
}

Size toSize(std::int64_t width, std::int64_t height) {
    return {static_cast<int>(width), static_cast<int>(height)};
}

} // namespace

std::optional<Size> parseSize(const std::string& text) {
    if (const auto side = numbers(text, 'x'); side && side->size() == 1 && isSide(side->front()))
        return toSize(side->front(), side->front());
    return parseWidthByHeight(text);
}

std::optional<Size> parseWidthByHeight(const std::string& text) {
    const auto sides = numbers(text, 'x');
    if (!sides || sides->size() != 2 || !isSide((*sides)[0]) || !isSide((*sides)[1]))
        return std::nullopt;
    return toSize((*sides)[0], (*sides)[1]);
}

std::optional<Rect> parseRect(const std::string& text) {
    const auto values = numbers(text, ',');
    if (!values || values->size() != 4 || !isSide((*values)[2]) || !isSide((*values)[3]))
        return std::nullopt;
    return Rect{(*values)[0], (*values)[1], toSize((*values)[2], (*values)[3])};
}

std::optional<std::pair<std::int64_t, std::int64_t>> parsePoint(const std::string& text) {
    const auto values = numbers(text, ',');
    if (!values || values->size() != 2)
        return std::nullopt;
    return std::pair((*values)[0], (*values)[1]);
}

std::optional<std::vector<double>>
parseNumbers(const std::string& text, std::size_t fewest, std::size_t most) {
    auto values = numbers<double>(text, ',');
    if (!values || values->size() < fewest || values->size() > most ||
        !std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); }))
        return std::nullopt;
    return values;
}

std::optional<SampleFormat> parseDepth(const std::string& text) {
    if (text == "8")
        return SampleFormat::UInt8;
    if (text == "16")
        return SampleFormat::UInt16;
    if (text == "half")
        return SampleFormat::Half;
    if (text == "float")
        return SampleFormat::Float;
    return std::nullopt;
}

CLI::Validator between(double low, double high) {
    const std::string range = CLI::detail::to_string(low) + " to " + CLI::detail::to_string(high);
    return {[=](const std::string& text) {
                double value = 0.0;
                const bool number = CLI::detail::lexical_cast(text, value);
                return number && value >= low && value <= high
                           ? std::string()
                           : "'" + text + "' is not a number from " + range;
            },
            range};
}

void addDepth(CLI::App& app, SaveOptions& options) {
    addParsed(app,
              "--depth",
              options.sampleFormat,
              parseDepth,
              "8|16|half|float",
              "Bits per sample (default: 8, for EXR half)");
}

} // namespace txn::cli
