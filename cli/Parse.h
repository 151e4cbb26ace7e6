// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/image/ImageIo.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace txn::cli {

/// "640x480" or "640"; both at least 1.
[[nodiscard]] std::optional<Size> parseSize(const std::string& text);
/// "640x480" only.
[[nodiscard]] std::optional<Size> parseWidthByHeight(const std::string& text);
/// "X,Y,W,H", the last two at least 1.
[[nodiscard]] std::optional<Rect> parseRect(const std::string& text);
/// "X,Y", of either sign.
[[nodiscard]] std::optional<std::pair<std::int64_t, std::int64_t>>
parsePoint(const std::string& text);
/// Numbers of any kind between commas, from fewest to most of them; none is infinite.
[[nodiscard]] std::optional<std::vector<double>>
parseNumbers(const std::string& text, std::size_t fewest, std::size_t most);
/// "8", "16", "half" or "float".
[[nodiscard]] std::optional<SampleFormat> parseDepth(const std::string& text);

/// Adds an option whose text is read by parse; anything it refuses is wrong usage.
template <class Value, class Parse>
CLI::Option* addParsed(CLI::App& app,
                       const std::string& name,
                       Value& target,
                       Parse parse,
                       const std::string& form,
                       const std::string& description) {
    return app
        .add_option_function<std::string>(
            name,
            [&target, parse, name, form](const std::string& text) {
                auto value = parse(text);
                if (!value)
                    throw CLI::ValidationError(name,
                                               "'" + text +
                                                   "' is out of range or not of the form " + form);
                target = *value;
            },
            description)
        ->type_name(form);
}

/// Accepts numbers from low to high; unlike CLI::Range, it does not let "nan" pass.
[[nodiscard]] CLI::Validator between(double low, double high);

/// --depth, for commands that write pictures.
void addDepth(CLI::App& app, SaveOptions& options);

} // namespace txn::cli
