// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/MapStack.h"

#include "core/image/ColorTransfer.h"
#include "core/material/NormalMap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace txn {
namespace {

Error wrongChannels(const MapPicture& picture, const std::string& wanted) {
    return {ErrorCode::Unsupported,
            "'" + picture.file + "' has " + std::to_string(picture.image.channels()) +
                " channels; a map of " + std::string(toString(picture.kind)) + " has " + wanted};
}

bool allEqual(const Image& image) {
    for (int c = 1; c < image.channels(); ++c) {
        if (!std::ranges::equal(image.plane(0), image.plane(c)))
            return false;
    }
    return true;
}

Image firstPlane(const Image& image) {
    Image result(image.size(), 1);
    std::ranges::copy(image.plane(0), result.plane(0).begin());
    return result;
}

/// The picture as channels of a stack.
Result<Image> stacked(MapPicture& picture) {
    Image& image = picture.image;
    const int channels = image.channels();
    if (picture.kind == MapKind::Color) {
        if (channels != 1 && channels != 3)
            return wrongChannels(picture, "1 or 3");
        return toEncoded(std::move(image));
    }
    image.setTransfer(Transfer::Encoded); // data has no curve
    switch (picture.kind) {
    case MapKind::Normal:
    case MapKind::NormalYDown:
        if (channels != 3)
            return wrongChannels(picture, "3");
        return slopesOfNormals(image, picture.kind == MapKind::NormalYDown);
    case MapKind::Packed:
        if (channels != 3)
            return wrongChannels(picture, "3: occlusion, roughness and metalness");
        break;
    case MapKind::Data:
    case MapKind::Color:
        break;
    default:
        if (channels == 1)
            break;
        if (!allEqual(image))
            return wrongChannels(picture, "1, or grey in all of them");
        return firstPlane(image);
    }
    return std::move(image);
}

} // namespace

Result<MapStack> stackMaps(std::vector<MapPicture> pictures) {
    if (pictures.empty())
        return Error{ErrorCode::InvalidArgument, "a stack needs at least one map"};
    MapStack stack;
    std::vector<Image> images;
    for (MapPicture& picture : pictures) {
        const Size size = picture.image.size();
        const Size first = images.empty() ? size : images.front().size();
        if (size != first)
            return Error{ErrorCode::SizeMismatch,
                         "'" + picture.file + "' is " + sizeText(size) + " and '" +
                             pictures.front().file + "' is " + sizeText(first) +
                             "; the maps of a material must match pixel for pixel"};
        if (std::ranges::any_of(stack.maps,
                                [&](const MaterialMap& map) { return map.name == picture.name; }))
            return Error{ErrorCode::InvalidArgument,
                         "there are two maps called '" + picture.name + "'; the second one is '" +
                             picture.file + "'"};
        auto image = stacked(picture);
        if (!image)
            return image.error();
        stack.maps.push_back({picture.name, picture.kind, image->channels()});
        images.push_back(std::move(*image));
    }
    const int channels = channelCount(stack.maps);
    if (channels > kMaxExemplarChannels)
        return Error{ErrorCode::Unsupported,
                     "the maps have " + std::to_string(channels) + " channels together; at most " +
                         std::to_string(kMaxExemplarChannels) + " can be used"};
    stack.image = Image(images.front().size(), channels);
    int next = 0;
    for (const Image& image : images) {
        for (int c = 0; c < image.channels(); ++c)
            std::ranges::copy(image.plane(c), stack.image.plane(next++).begin());
    }
    return stack;
}

Image mapPicture(const Image& stack, const MaterialMaps& maps, std::size_t map) {
    const MaterialMap& of = maps[map];
    const int first = firstChannel(maps, map);
    Image part(stack.size(), of.channels, 0.0F, stack.transfer());
    for (int c = 0; c < of.channels; ++c)
        std::ranges::copy(stack.plane(first + c), part.plane(c).begin());
    return isNormal(of.kind) ? normalsOfSlopes(part, of.kind == MapKind::NormalYDown) : part;
}

Image firstPicture(const Image& image, const MaterialMaps& maps) {
    return maps.empty() ? image : mapPicture(image, maps, 0);
}

void turnSlopes(Image& stack, const MaterialMaps& maps, double degreesCounterClockwise) {
    const double angle = degreesCounterClockwise * std::numbers::pi / 180.0;
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    for (std::size_t m = 0; m < maps.size(); ++m) {
        if (!isNormal(maps[m].kind))
            continue;
        const auto x = stack.plane(firstChannel(maps, m));
        const auto y = stack.plane(firstChannel(maps, m) + 1);
        // With y down, turning counter-clockwise takes (1, 0) to (c, -s).
        for (std::size_t i = 0; i < x.size(); ++i) {
            const float dx = c * x[i] + s * y[i];
            y[i] = c * y[i] - s * x[i];
            x[i] = dx;
        }
    }
}

void flipGreen(Image& stack, MaterialMaps& maps) {
    for (std::size_t m = 0; m < maps.size(); ++m) {
        if (!isNormal(maps[m].kind))
            continue;
        for (float& v : stack.plane(firstChannel(maps, m) + 1))
            v = -v;
        maps[m].kind = maps[m].kind == MapKind::Normal ? MapKind::NormalYDown : MapKind::Normal;
    }
}

} // namespace txn
