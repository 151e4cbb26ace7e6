// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Thumbnail.h"

#include "app/display/PicturePyramid.h"
#include "app/document/Project.h"
#include "core/image/ImageGeometry.h"
#include "core/image/ImageResize.h"
#include "core/material/MapStack.h"
#include "core/sheet/ContactSheet.h"

#include <QBuffer>
#include <QImage>
#include <new>

namespace txn::app {
namespace {

constexpr int kThumbnailPx = 256;

Image preview(const Project& project) {
    if (project.importedTexton)
        return firstPicture(textonPicture(project.importedTexton->texton, {0, 0}),
                            project.importedTexton->maps);
    const auto picture = project.source ? project.source->picture() : Error{};
    if (!picture)
        return {};
    const auto& crop = project.edit.crop;
    const auto part = crop ? txn::crop((*picture)->image, *crop) : Error{};
    return firstPicture(part ? *part : (*picture)->image, project.source->maps());
}

} // namespace

QByteArray thumbnail(const Project& project) try {
    const auto small = shrunkTo(preview(project), {kThumbnailPx, kThumbnailPx});
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (small && buffer.open(QIODevice::WriteOnly))
        toQImage(*small).save(&buffer, "PNG");
    return bytes;
} catch (const std::bad_alloc&) {
    return {}; // work is saved without it
}

} // namespace txn::app
