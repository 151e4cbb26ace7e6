// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/TextonFile.h"

#include "core/base/PlainText.h"
#include "core/base/Version.h"
#include "core/gaussian/Exemplar.h"
#include "core/spectral/BSpline.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace txn {
namespace {

constexpr int kMaxSide = 16384;

Error brokenText(const std::string& reason) {
    return {ErrorCode::Unreadable, reason};
}

void append(std::string& text, double value) {
    std::array<char, 32> buffer{};
    // Nine digits tell every float apart from its neighbours.
    const auto end = std::to_chars(buffer.data(),
                                   buffer.data() + buffer.size(),
                                   value,
                                   std::chars_format::general,
                                   9);
    text.append(buffer.data(), end.ptr);
}

/// Whitespace-separated words; knows the line for messages.
class Reader {
  public:
    explicit Reader(std::string_view text) : m_text(text) {}

    std::string_view word() {
        while (!m_text.empty() && isSpace(m_text.front())) {
            m_line += m_text.front() == '\n' ? 1 : 0;
            m_text.remove_prefix(1);
        }
        std::size_t length = 0;
        while (length < m_text.size() && !isSpace(m_text[length]))
            ++length;
        const auto result = m_text.substr(0, length);
        m_text.remove_prefix(length);
        return result;
    }

    template <class Number>
    std::optional<Number> number() {
        std::string_view digits = word();
        if (digits.starts_with('+') && !digits.starts_with("+-"))
            digits.remove_prefix(1);
        Number value{};
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || digits.empty())
            return std::nullopt;
        return value;
    }

    int line() const { return m_line; }

  private:
    static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

    std::string_view m_text;
    int m_line = 1;
};

} // namespace

Result<std::string> toTextonFile(const TextonAsset& asset) {
    const Texton& texton = asset.texton;
    const int channels = texton.channels();
    if (texton.kernelCount() != 1)
        return Error{ErrorCode::Unsupported,
                     "a .texton file holds one kernel and this texton has " +
                         std::to_string(texton.kernelCount()) + "; use EXR"};
    if (channels != 1 && channels != 3)
        return Error{ErrorCode::Unsupported,
                     "a .texton file holds 1 or 3 channels and this texton has " +
                         std::to_string(channels) + "; use EXR"};
    const auto source = [&](int c) { return channels == 1 ? 0 : c; };
    const Image& kernel = texton.kernels.front();
    std::string text = "TEXTON\n1\n" + std::to_string(texton.interpolationOrder) + "\n";
    for (int c = 0; c < 3; ++c) {
        append(text, texton.mean[static_cast<std::size_t>(source(c))]);
        text += c < 2 ? ' ' : '\n';
    }
    text += std::to_string(kernel.width() + 2) + " " + std::to_string(kernel.height() + 2) + "\n";
    for (int y = kernel.height(); y >= -1; --y) {
        for (int x = -1; x <= kernel.width(); ++x) {
            const bool frame = x < 0 || y < 0 || x >= kernel.width() || y >= kernel.height();
            for (int c = 0; c < 3; ++c) {
                append(text, frame ? 0.0 : static_cast<double>(kernel.at(x, y, source(c))));
                text += c < 2 ? ' ' : '\n';
            }
        }
    }
    text += "Texton of " + inOneLine(asset.exemplarName) + ", made by Texton Studio " +
            kProgramVersion + "\n";
    return text;
}

Result<TextonAsset> fromTextonFile(std::string_view text) {
    Reader reader(text);
    if (reader.word() != "TEXTON")
        return brokenText("it does not start with TEXTON");
    const auto version = reader.number<int>();
    if (version != 1)
        return brokenText("only version 1 of the format is known");
    const auto order = reader.number<int>();
    if (!order || !isInterpolationOrder(*order))
        return brokenText("the interpolation order must be 0, 1, 3 or 5");
    TextonAsset asset;
    asset.texton.interpolationOrder = *order;
    for (int c = 0; c < 3; ++c) {
        const auto mean = reader.number<double>();
        if (!mean || !(std::abs(*mean) <= Exemplar::kLargestSample))
            return brokenText("line " + std::to_string(reader.line()) +
                              " should hold the mean colour");
        asset.texton.mean.push_back(*mean);
    }
    const auto width = reader.number<int>();
    const auto height = reader.number<int>();
    if (!width || !height || *width < 3 || *height < 3 || *width > kMaxSide || *height > kMaxSide)
        return brokenText("line " + std::to_string(reader.line()) +
                          " should hold the width and height, with the border of one");
    const Size support{*width - 2, *height - 2};
    // Three numbers of two characters each are the least a sample can take.
    if (support.area() * 6 > text.size())
        return brokenText("it ends too early");
    Image kernel(support, 3);
    for (int y = support.height; y >= -1; --y) {
        for (int x = -1; x <= support.width; ++x) {
            const bool frame = x < 0 || y < 0 || x >= support.width || y >= support.height;
            for (int c = 0; c < 3; ++c) {
                const auto value = reader.number<double>(); // which takes what a float rounds to 0
                if (!value || !(std::abs(static_cast<float>(*value)) <= Exemplar::kLargestSample))
                    return brokenText("line " + std::to_string(reader.line()) +
                                      " should hold three coefficients");
                if (frame && *value != 0.0)
                    return brokenText("line " + std::to_string(reader.line()) +
                                      " lies on the border and should hold zeros");
                if (!frame)
                    kernel.at(x, y, c) = static_cast<float>(*value);
            }
        }
    }
    asset.texton.support = Support::rectangle(support);
    asset.texton.kernels.push_back(std::move(kernel));
    return asset;
}

} // namespace txn
