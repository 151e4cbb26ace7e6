// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Paths.h"

#include "core/base/OutputFiles.h"

namespace txn::cli {

Result<void> checkOutput(const std::filesystem::path& input, const std::filesystem::path& output) {
    std::error_code ec;
    if (std::filesystem::equivalent(input, output, ec))
        return Error{ErrorCode::InvalidArgument,
                     quoted(output) + " is what is read; give the output another name"};
    return {};
}

} // namespace txn::cli
