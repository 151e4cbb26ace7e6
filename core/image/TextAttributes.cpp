// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/TextAttributes.h"

#include <algorithm>

namespace txn {

std::string textFromAttributes(const ImageAttributes& attributes) {
    std::string text;
    for (const auto& [name, value] : attributes) {
        text += name + "=";
        for (const char c : value) {
            if (c == '\n')
                text += "\\n";
            else if (c == '\\')
                text += "\\\\";
            else
                text += c;
        }
        text += '\n';
    }
    return text;
}

ImageAttributes attributesFromText(std::string_view text) {
    ImageAttributes attributes;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        const auto equals = line.find('=');
        if (!line.starts_with(kAttributePrefix) || equals == std::string_view::npos)
            continue;
        std::string value;
        for (std::size_t i = equals + 1; i < line.size(); ++i) {
            if (line[i] != '\\' || i + 1 == line.size())
                value += line[i];
            else
                value += line[++i] == 'n' ? '\n' : line[i];
        }
        attributes[std::string(line.substr(0, equals))] = value;
    }
    return attributes;
}

} // namespace txn
