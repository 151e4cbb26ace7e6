// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/Exemplar.h"

#include <algorithm>
#include <cmath>

namespace txn {

Result<Exemplar> makeExemplar(Image image, std::string name, MaterialMaps maps) {
    if (image.empty())
        return Error{ErrorCode::InvalidArgument, "'" + name + "' holds no pixels"};
    if (image.channels() > kMaxExemplarChannels)
        return Error{ErrorCode::Unsupported,
                     "'" + name + "' has " + std::to_string(image.channels()) +
                         " channels; at most " + std::to_string(kMaxExemplarChannels) +
                         " can be used"};
    if (!maps.empty() && !areMapsOf(maps, image.channels()))
        return Error{ErrorCode::SizeMismatch,
                     "the maps of '" + name + "' do not match its channels"};
    const auto samples = image.samples();
    const auto bad = std::find_if(samples.begin(), samples.end(), [](float v) {
        return !(std::abs(v) <= Exemplar::kLargestSample); // catches NaN, too
    });
    if (bad != samples.end()) {
        const auto sample = static_cast<std::size_t>(bad - samples.begin());
        const auto pixel = sample % image.size().area();
        const auto channel = static_cast<int>(sample / image.size().area());
        std::string where;
        for (std::size_t m = 0; m < maps.size(); ++m) {
            if (firstChannel(maps, m) <= channel)
                where = ", map '" + maps[m].name + "',";
        }
        const auto width = static_cast<std::size_t>(image.width());
        return Error{ErrorCode::Degenerate,
                     "'" + name + "'" + where + " has a sample that is not a usable number at x " +
                         std::to_string(pixel % width) + ", y " + std::to_string(pixel / width) +
                         "; repair the picture or crop that part away"};
    }
    return Exemplar{std::move(image), std::move(name), std::move(maps)};
}

} // namespace txn
