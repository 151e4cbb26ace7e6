// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/ShaderLibrary.h"

#include "gl/ShaderFiles.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace txn {
namespace {

constexpr std::string_view kInclude = "#include \"";

Result<void> append(std::string_view name, std::set<std::string>& seen, std::string& out) {
    const auto files = shaderFiles();
    const auto file = std::find_if(files.begin(), files.end(), [&](const ShaderFile& candidate) {
        return candidate.name == name;
    });
    if (file == files.end())
        return Error{ErrorCode::NotFound, "there is no shader '" + std::string(name) + "'"};
    if (!seen.insert(std::string(name)).second)
        return {};
    std::istringstream lines{std::string(file->text)};
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(kInclude)) {
            const std::string other =
                line.substr(kInclude.size(), line.rfind('"') - kInclude.size());
            if (auto ok = append(other, seen, out); !ok)
                return ok.error();
        } else {
            out += line + '\n';
        }
    }
    return {};
}

} // namespace

Result<std::string> shaderText(std::string_view name, const ShaderDefines& defines) {
    std::string text = "#version 330 core\n";
    for (const auto& [key, value] : defines)
        text.append("#define ").append(key).append(" ").append(value).append("\n");
    std::set<std::string> seen;
    if (auto ok = append(name, seen, text); !ok)
        return ok.error();
    return text;
}

} // namespace txn
