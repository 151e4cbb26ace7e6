// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Paths.h"

#include "core/base/OutputFiles.h"
#include "core/image/ImageIo.h"

namespace txn::cli {

Result<void> checkNotInput(const std::filesystem::path& input,
                           const std::filesystem::path& output) {
    std::error_code ec;
    if (std::filesystem::equivalent(input, output, ec))
        return Error{ErrorCode::InvalidArgument,
                     quoted(output) + " is what is read; give the output another name"};
    return {};
}

Result<void> checkPictureOutput(const std::filesystem::path& output) {
    if (const auto format = imageFormatForPath(output); !format)
        return format.error();
    OutputFiles files;
    if (const auto ok = files.add(output); !ok)
        return ok.error();
    return {};
}

Result<void> checkPictureOutput(const std::filesystem::path& input,
                                const std::filesystem::path& output) {
    if (const auto ok = checkNotInput(input, output); !ok)
        return ok.error();
    return checkPictureOutput(output);
}

} // namespace txn::cli
