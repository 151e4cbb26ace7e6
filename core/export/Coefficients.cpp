// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/Coefficients.h"

#include <algorithm>

namespace txn {
namespace {

std::string channelName(int channel, int channels) {
    if (channels == 1)
        return "Y";
    if (channels == 3)
        return {"RGB"[channel]};
    return "ch" + std::to_string(channel);
}

} // namespace

Image framedCoefficients(const Texton& texton) {
    Image image(texton.footprint(),
                texton.kernelCount() * texton.channels(),
                0.0F,
                texton.transfer);
    int plane = 0;
    for (const Image& kernel : texton.kernels) {
        for (int c = 0; c < kernel.channels(); ++c, ++plane) {
            for (int y = 0; y < kernel.height(); ++y)
                std::ranges::copy(kernel.row(c, y),
                                  image.row(plane, y + texton.frame()).begin() + texton.frame());
        }
    }
    return image;
}

std::vector<std::string> coefficientNames(const TextonAsset& asset) {
    const Texton& texton = asset.texton;
    const auto ofMaps = channelNames(asset.maps);
    std::vector<std::string> names;
    for (int q = 0; q < texton.kernelCount(); ++q) {
        const std::string layer =
            texton.kernelCount() > 1 ? "kernel" + std::to_string(q) + "." : std::string();
        for (int c = 0; c < texton.channels(); ++c)
            names.push_back(layer + (ofMaps.empty() ? channelName(c, texton.channels())
                                                    : ofMaps[static_cast<std::size_t>(c)]));
    }
    return names;
}

} // namespace txn
