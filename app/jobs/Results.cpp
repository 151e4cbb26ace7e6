// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/Results.h"

#include "core/material/MapStack.h"

namespace txn::app {

MapPictures mapPictures(const Image& image, const MaterialMaps& maps) {
    MapPictures pictures;
    if (maps.empty())
        pictures.emplace_back(image);
    for (std::size_t m = 0; m < maps.size(); ++m)
        pictures.emplace_back(mapPicture(image, maps, m));
    return pictures;
}

} // namespace txn::app
