// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/TextonAsset.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/helpers/Textons.h"

#include <nlohmann/json.hpp>

namespace txn::fuzz {
namespace {

using Json = nlohmann::ordered_json;

} // namespace

bool readOne(std::string_view bytes) {
    const auto json = Json::parse(bytes, nullptr, false);
    if (json.is_discarded())
        return false;
    const auto first = parseDescription(json);
    if (!first)
        return false;
    const Texton& texton = first->asset.texton;
    require(static_cast<int>(texton.mean.size()) == texton.channels() &&
                first->code.scale.size() == texton.mean.size() &&
                first->code.bias.size() == texton.mean.size(),
            "there is a number for each channel");
    require(first->asset.maps.empty() || areMapsOf(first->asset.maps, texton.channels()),
            "the maps are those of the channels");
    return true;
}

std::vector<std::string> seeds() {
    std::vector<std::string> texts;
    for (const int channels : {1, 3, 4}) {
        TextonAsset asset;
        asset.texton = test::makeTexton({.kernels = 2, .size = {3, 3}, .channels = channels});
        asset.exemplarName = "seed";
        if (channels == 3)
            asset.texton.support = Support::disc(3);
        if (channels == 4)
            asset.maps = {{"albedo", MapKind::Color, 3}, {"height", MapKind::Data, 1}};
        const auto count = static_cast<std::size_t>(channels);
        const SampleCode code{std::vector<double>(count, 1.0), std::vector<double>(count)};
        texts.push_back(describe(asset, code).dump());
    }
    return texts;
}

} // namespace txn::fuzz
