// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Thumbnail.h"

#include "app/display/PicturePyramid.h"
#include "app/document/Project.h"
#include "core/image/ImageGeometry.h"
#include "core/material/MapStack.h"
#include "core/sheet/ContactSheet.h"

#include <QBuffer>
#include <QImage>

namespace txn::app {
namespace {

constexpr int kThumbnailPx = 256;

QImage preview(const Project& project) {
    if (project.importedTexton)
        return toQImage(firstPicture(textonPicture(project.importedTexton->texton, {0, 0}),
                                     project.importedTexton->maps));
    const auto picture = project.source ? project.source->picture() : Error{};
    if (!picture)
        return {};
    const auto& crop = project.edit.crop;
    const auto part = crop ? txn::crop((*picture)->image, *crop) : Error{};
    return toQImage(firstPicture(part ? *part : (*picture)->image, project.source->maps()));
}

} // namespace

QByteArray thumbnail(const Project& project) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    const QImage image = preview(project);
    if (!image.isNull() && buffer.open(QIODevice::WriteOnly))
        image.scaled(kThumbnailPx, kThumbnailPx, Qt::KeepAspectRatio, Qt::SmoothTransformation)
            .save(&buffer, "PNG");
    return bytes;
}

} // namespace txn::app
