// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/TextonFile.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/helpers/Textons.h"

namespace txn::fuzz {

bool readOne(std::string_view bytes) {
    const auto asset = fromTextonFile(bytes);
    if (!asset)
        return false;
    const auto text = toTextonFile(*asset);
    require(static_cast<bool>(text), "what was read can be written");
    const auto again = fromTextonFile(*text);
    require(static_cast<bool>(again), "what was written can be read");
    require(again->texton.kernels == asset->texton.kernels, "every coefficient survives");
    return true;
}

std::vector<std::string> seeds() {
    std::vector<std::string> texts;
    for (const int order : {0, 1, 3, 5}) {
        TextonAsset asset;
        asset.texton = test::makeTexton({.order = order, .size = {2, 3}, .channels = 3});
        asset.exemplarName = "seed";
        texts.push_back(*toTextonFile(asset));
    }
    return texts;
}

} // namespace txn::fuzz
