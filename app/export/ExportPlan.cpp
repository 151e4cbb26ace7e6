// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/ExportPlan.h"

#include "core/base/PlainText.h"

#include <QDir>

namespace txn::app {
namespace {

constexpr qsizetype kMaxNameLength = 120;

QString ending(ImageFormat format) {
    switch (format) {
    case ImageFormat::OpenExr:
        return QStringLiteral(".exr");
    case ImageFormat::Tiff:
        return QStringLiteral(".tif");
    default:
        return QStringLiteral(".png");
    }
}

QString sizeWord(Size size) {
    return size.width == size.height ? QString::number(size.width)
                                     : QStringLiteral("%1x%2").arg(size.width).arg(size.height);
}

QString safe(const QString& wanted) {
    QString name = QString::fromStdString(inOneLine(wanted.toStdString()));
    for (QChar& c : name) {
        if (QStringLiteral("/\\:*?\"<>|").contains(c))
            c = QLatin1Char('_');
    }
    while (name.startsWith(QLatin1Char('.')) || name.startsWith(QLatin1Char(' ')))
        name.remove(0, 1);
    while (name.endsWith(QLatin1Char('.')) || name.endsWith(QLatin1Char(' ')))
        name.chop(1);
    name.truncate(kMaxNameLength);
    return name.isEmpty() ? QStringLiteral("texton") : name;
}

/// The file, or one for each map.
QStringList mapFiles(const QString& file, const MaterialMaps& maps) {
    if (maps.empty())
        return {file};
    QStringList files;
    for (const MaterialMap& map : maps)
        files << QString::fromStdString(mapFile(file.toStdString(), map.name).string());
    return files;
}

} // namespace

QString standardTemplate(const ExportPlan& plan) {
    switch (plan.kind) {
    case ExportKind::Texton:
        return QStringLiteral("{name}_texton{support}");
    case ExportKind::Noise:
        return plan.tileable ? QStringLiteral("{name}_noise_{size}_tile")
                             : QStringLiteral("{name}_noise_{size}");
    case ExportKind::View:
        return QStringLiteral("{name}_view");
    case ExportKind::Mixture:
        return QStringLiteral("{name}_mixture");
    case ExportKind::Engine:
        break;
    }
    return QStringLiteral("{name}_shader");
}

QString exportName(const ExportPlan& plan, const ExportSnapshot& snapshot) {
    QString name = plan.nameTemplate.trimmed().isEmpty() ? standardTemplate(plan)
                                                         : plan.nameTemplate.trimmed();
    name.replace(QLatin1String("{support}"), sizeWord(snapshot.asset.texton.support.size()));
    name.replace(QLatin1String("{mni}"), QString::number(snapshot.noise.meanImpacts));
    name.replace(QLatin1String("{seed}"), QString::number(snapshot.noise.seed.value));
    name.replace(QLatin1String("{size}"), sizeWord(plan.size));
    // Last: what a file is called is not looked at for words.
    name.replace(QLatin1String("{name}"), snapshot.name);
    return safe(name);
}

QString noiseFile(const ExportPlan& plan, const ExportSnapshot& snapshot) {
    return QDir(plan.folder).filePath(exportName(plan, snapshot)) + ending(plan.format);
}

QStringList exportFiles(const ExportPlan& plan, const ExportSnapshot& snapshot) {
    const QString base = QDir(plan.folder).filePath(exportName(plan, snapshot));
    switch (plan.kind) {
    case ExportKind::Texton: {
        // Each with its sidecar.
        QStringList files;
        for (const auto& [wanted, end] : {std::pair(plan.textonExr, ".exr"),
                                          std::pair(plan.textonPng, ".png"),
                                          std::pair(plan.textonFile, ".texton")}) {
            const QString file = base + QLatin1String(end);
            if (wanted && QLatin1String(end) == QLatin1String(".png"))
                files << mapFiles(file, snapshot.asset.maps) << file + QStringLiteral(".json");
            else if (wanted)
                files << file << file + QStringLiteral(".json");
        }
        return files;
    }
    case ExportKind::Noise:
        return plan.format == ImageFormat::OpenExr
                   ? QStringList{noiseFile(plan, snapshot)}
                   : mapFiles(noiseFile(plan, snapshot), snapshot.asset.maps);
    case ExportKind::View:
        return {base + QStringLiteral(".png")};
    case ExportKind::Mixture: {
        QStringList files;
        const std::size_t textons = snapshot.mixture ? snapshot.mixture->mixture.textons.size() : 0;
        if (textons > 0) {
            for (const auto& file : mixtureFiles(base.toStdString(), textons))
                files << QString::fromStdString(file.string());
        }
        return files;
    }
    case ExportKind::Engine:
        break;
    }
    return {base + QStringLiteral(".exr"),
            base + QStringLiteral(".exr.json"),
            base + QStringLiteral(".glsl"),
            base + QStringLiteral(".f32"),
            base + QStringLiteral(".json"),
            base + QStringLiteral("_example.cpp")};
}

} // namespace txn::app
