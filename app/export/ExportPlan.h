// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"
#include "core/export/MixtureExport.h"

#include <QImage>
#include <QStringList>

namespace txn::app {

enum class ExportKind { Texton, Noise, View, Engine, Mixture };

/// What the artist wants to have written. A plain value.
struct ExportPlan {
    static constexpr int kMaxSidePx = 65536;

    ExportKind kind = ExportKind::Texton;
    QString folder;
    /// With {name} {support} {mni} {seed} {size}; empty: that of the kind.
    QString nameTemplate;

    bool textonExr = true; ///< at least one of the three
    bool textonPng = false;
    bool textonFile = false;

    Size size{2048, 2048};
    bool tileable = true;
    std::int64_t originX = 0; ///< where a region starts; a tileable picture starts at 0
    std::int64_t originY = 0;
    ImageFormat format = ImageFormat::Png;
    SampleFormat depth = SampleFormat::UInt8;

    bool operator==(const ExportPlan&) const = default;
};

/// What is exported, as it was when the export began.
struct ExportSnapshot {
    QString name;      ///< of the material: the exemplar's without its ending
    TextonAsset asset; ///< with the noise's contrast and brightness
    /// Where there are two materials, likewise: noise is made of it.
    std::shared_ptr<const MixtureAsset> mixture;
    NoiseSettings noise;
    QImage view; ///< what is on screen
};

[[nodiscard]] QString standardTemplate(const ExportPlan& plan);

/// The template with its words put in, safe as a file name everywhere: no slashes or other special
/// characters, no dot at the start, at most 120 characters, never empty.
[[nodiscard]] QString exportName(const ExportPlan& plan, const ExportSnapshot& snapshot);

/// Where noise goes; of a stack, what its files' names are made of.
[[nodiscard]] QString noiseFile(const ExportPlan& plan, const ExportSnapshot& snapshot);

/// Every file that the export will write, sidecars included, in the plan's folder.
[[nodiscard]] QStringList exportFiles(const ExportPlan& plan, const ExportSnapshot& snapshot);

/// A kind of picture file that noise can be written as.
struct ExportFormat {
    const char* name; ///< to be translated in the context of ExportDialog
    ImageFormat format;
    SampleFormat depth;
};
inline constexpr std::array kExportFormats{
    ExportFormat{QT_TRANSLATE_NOOP("txn::app::ExportDialog", "PNG, 8 bit"),
                 ImageFormat::Png,
                 SampleFormat::UInt8},
    ExportFormat{QT_TRANSLATE_NOOP("txn::app::ExportDialog", "PNG, 16 bit"),
                 ImageFormat::Png,
                 SampleFormat::UInt16},
    ExportFormat{QT_TRANSLATE_NOOP("txn::app::ExportDialog", "EXR, 16 bit float"),
                 ImageFormat::OpenExr,
                 SampleFormat::Half},
    ExportFormat{QT_TRANSLATE_NOOP("txn::app::ExportDialog", "EXR, 32 bit float"),
                 ImageFormat::OpenExr,
                 SampleFormat::Float},
    ExportFormat{QT_TRANSLATE_NOOP("txn::app::ExportDialog", "TIFF, 8 bit"),
                 ImageFormat::Tiff,
                 SampleFormat::UInt8},
    ExportFormat{QT_TRANSLATE_NOOP("txn::app::ExportDialog", "TIFF, 16 bit"),
                 ImageFormat::Tiff,
                 SampleFormat::UInt16},
    ExportFormat{QT_TRANSLATE_NOOP("txn::app::ExportDialog", "TIFF, 32 bit float"),
                 ImageFormat::Tiff,
                 SampleFormat::Float}};

} // namespace txn::app
