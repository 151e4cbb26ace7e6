// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageResize.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

namespace txn {
namespace {

OIIO::ImageSpec onePlane(Size size) {
    return {size.width, size.height, 1, OIIO::TypeFloat};
}

} // namespace

Result<Image> shrunkTo(const Image& image, Size atMost) {
    if (image.empty() || atMost.width < 1 || atMost.height < 1)
        return Error{ErrorCode::InvalidArgument, "there is nothing to shrink"};
    const double scale = std::min(static_cast<double>(atMost.width) / image.width(),
                                  static_cast<double>(atMost.height) / image.height());
    if (scale >= 1.0)
        return image;
    const auto side = [scale](int full) {
        return std::max(1, static_cast<int>(std::lround(full * scale)));
    };
    Image result({side(image.width()), side(image.height())},
                 image.channels(),
                 0.0F,
                 image.transfer());
    try {
        for (int c = 0; c < image.channels(); ++c) {
            // Only read, though the buffer's type cannot say so.
            auto* samples = const_cast<float*>(image.plane(c).data());
            const OIIO::ImageBuf from(onePlane(image.size()), samples);
            OIIO::ImageBuf to(onePlane(result.size()), result.plane(c).data());
            if (!OIIO::ImageBufAlgo::resize(to, from))
                return Error{ErrorCode::Unsupported, "cannot shrink a picture: " + to.geterror()};
        }
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Unsupported,
                     std::string("cannot shrink a picture: ") + failure.what()};
    }
    return result;
}

} // namespace txn
