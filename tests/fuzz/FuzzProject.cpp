// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectFile.h"
#include "app/document/ProjectReader.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/helpers/Textons.h"

#include <QCborMap>
#include <QCborValue>

namespace txn::fuzz {
namespace {

using namespace txn::app;

// Nothing lies there, so that links lead nowhere.
const QString kFolder = QStringLiteral("/nonexistent");

std::string text(const QByteArray& bytes) {
    return bytes.toStdString();
}

/// The settings of a mixture are read only where there is a photo, whose decoding is not for this
/// target.
void readMixture(const QByteArray& bytes) {
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(bytes, &problem);
    if (problem.error != QCborError::NoError) // Qt's maps that end in a key crash on look-ups
        return;
    CborReader mixture(CborReader(value.taggedValue(value).toMap()).map("mix"));
    MixSettings mix;
    if (!readMixSettings(mixture, mix))
        return;
    const auto again = PaintedMap::fromBytes(mix.map.toBytes(), mix.map.size());
    require(static_cast<bool>(again) && *again == mix.map, "a map survives");
}

} // namespace

bool readOne(std::string_view view) {
    const QByteArray bytes(view.data(), static_cast<qsizetype>(view.size()));
    readMixture(bytes);
    const auto saved = decodeProject(bytes, kFolder + QStringLiteral("/fuzz.txnproj"));
    if (!saved)
        return false;
    const auto encoded =
        encodeProject(saved->project, saved->view, ExemplarStorage::Embedded, kFolder);
    const auto again = decodeProject(encoded, kFolder + QStringLiteral("/fuzz.txnproj"));
    require(static_cast<bool>(again), "what was written can be read");
    Project a = saved->project;
    Project b = again->project;
    require((a.importedTexton == nullptr) == (b.importedTexton == nullptr), "the texton survives");
    require(!a.importedTexton || *a.importedTexton == *b.importedTexton, "the texton survives");
    a.importedTexton = b.importedTexton = nullptr;
    a.source = b.source = nullptr;
    a.mix.source = b.mix.source = nullptr;
    require(a == b, "the settings survive");
    return true;
}

std::vector<std::string> seeds() {
    std::vector<std::string> files;
    for (const int channels : {1, 4}) {
        Project project;
        TextonAsset asset;
        asset.texton = test::makeTexton({.kernels = 2, .size = {3, 3}, .channels = channels});
        if (channels == 4)
            asset.maps = {{"albedo", MapKind::Color, 3}, {"height", MapKind::Data, 1}};
        project.importedTexton = std::make_shared<const TextonAsset>(asset);
        project.edit.crop = Rect{1, 2, {3, 4}};
        project.edit.flattenRadiusPx = 5.0;
        ViewState view;
        view.channel = channels - 1;
        const QByteArray whole = encodeProject(project, view, ExemplarStorage::Embedded, kFolder);
        files.push_back(text(whole));
        const QCborValue value = QCborValue::fromCbor(whole);
        QCborMap map = value.taggedValue(value).toMap();
        Image mixing({70, 3}, 1);
        for (std::size_t i = 0; i < mixing.samples().size(); ++i)
            mixing.samples()[i] = static_cast<float>(i % 7) / 7.0F;
        map[QStringLiteral("mix")] =
            QCborMap{{QStringLiteral("textons"), 5},
                     {QStringLiteral("map_width"), 70},
                     {QStringLiteral("map_height"), 3},
                     {QStringLiteral("map"), PaintedMap::fromImage(mixing).toBytes()}};
        files.push_back(text(QCborValue(QCborKnownTags::Signature, map).toCbor()));
    }
    return files;
}

} // namespace txn::fuzz
