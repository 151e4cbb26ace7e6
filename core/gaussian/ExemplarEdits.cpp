// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/ExemplarEdits.h"

#include "core/image/ImageGeometry.h"
#include "core/material/MapStack.h"
#include "core/spectral/Lighting.h"

#include <algorithm>

namespace txn {

Result<Exemplar>
turned(Exemplar exemplar, double degreesCounterClockwise, const CancelToken& cancel) {
    auto image = rotated(exemplar.image, degreesCounterClockwise, cancel);
    if (!image)
        return image.error();
    exemplar.image = std::move(*image);
    turnSlopes(exemplar.image, exemplar.maps, degreesCounterClockwise);
    return exemplar;
}

Result<Exemplar> lightingEvened(Exemplar exemplar, double radiusPx, const CancelToken& cancel) {
    if (exemplar.maps.empty()) {
        auto even = flattenLighting(exemplar.image, radiusPx, cancel);
        if (!even)
            return even.error();
        exemplar.image = std::move(*even);
        return exemplar;
    }
    for (std::size_t m = 0; m < exemplar.maps.size(); ++m) {
        if (exemplar.maps[m].kind != MapKind::Color)
            continue;
        const auto even =
            flattenLighting(mapPicture(exemplar.image, exemplar.maps, m), radiusPx, cancel);
        if (!even)
            return even.error();
        const int first = firstChannel(exemplar.maps, m);
        for (int c = 0; c < even->channels(); ++c)
            std::ranges::copy(even->plane(c), exemplar.image.plane(first + c).begin());
    }
    return exemplar;
}

} // namespace txn
