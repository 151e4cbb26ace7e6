// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mixing/MixEditor.h"

#include "app/look/Words.h"
#include "core/base/OutputFiles.h"
#include "core/export/MixtureExport.h"
#include "core/image/ImageIo.h"
#include "core/mixing/MapBrush.h"

#include <QFile>
#include <QFileInfo>

namespace txn::app {
namespace {

std::filesystem::path pathOf(const QString& path) {
    return QFile::encodeName(path).toStdString();
}

Image inverted(Image rho) {
    for (float& v : rho.samples())
        v = 1.0F - v;
    return rho;
}

Result<PaintedMap> readMap(const QString& path) {
    const auto picture = loadImage(pathOf(path));
    if (!picture)
        return picture.error();
    const std::string name = QFileInfo(path).fileName().toStdString();
    const auto rho = mapFromPicture(picture->image, name);
    if (!rho)
        return rho.error();
    if (rho->width() > MixSettings::kMaxMapSide || rho->height() > MixSettings::kMaxMapSide)
        return Error{ErrorCode::TooLarge,
                     "the mixing map '" + name + "' is larger than " +
                         std::to_string(MixSettings::kMaxMapSide) + " pixels; scale it down"};
    return PaintedMap::fromImage(*rho);
}

Result<void> writeMap(const PaintedMap& map, const QString& path) {
    MixingMap whole;
    whole.rho = map.image();
    OutputFiles files;
    if (const auto ok = addMixingMap(whole, pathOf(path), files); !ok)
        return ok.error();
    return files.commit();
}

} // namespace

MixEditor::MixEditor(ProjectDocument& document, JobRunner& runner, QObject* parent)
    : QObject(parent), m_document(document), m_runner(runner) {}

void MixEditor::setMap(const QString& text, const Image& rho) {
    m_document.change(text,
                      [&](Project& project) { project.mix.map = PaintedMap::fromImage(rho); });
}

void MixEditor::swapMaterials() {
    if (!m_document.project().mix.source)
        return;
    const Image rho = inverted(m_document.project().mix.map.image());
    m_document.change(tr("Swap A and B"), [&](Project& project) {
        std::swap(project.source, project.mix.source);
        std::swap(project.edit, project.mix.edit);
        project.mix.map = PaintedMap::fromImage(rho);
    });
}

void MixEditor::removeSecond() {
    m_document.change(tr("Remove B"), [](Project& project) { project.mix = MixSettings{}; });
}

void MixEditor::fill(double rho) {
    setMap(tr("Fill the map"),
           Image(m_document.project().mix.map.size(), 1, static_cast<float>(rho)));
}

void MixEditor::makeStrips(double degreesClockwise) {
    const MixSettings& mix = m_document.project().mix;
    setMap(tr("Strips from A to B"), stripMap(mix.map.size(), mix.textons, degreesClockwise));
}

void MixEditor::makePassage() {
    setMap(tr("Smooth passage from A to B"),
           gradientMap(m_document.project().mix.map.size(), 0.0, Ease::Smooth));
}

void MixEditor::invertMap() {
    setMap(tr("Invert the map"), inverted(m_document.project().mix.map.image()));
}

void MixEditor::setRepeats(bool repeats) {
    m_document.change(tr("Repeat the map"),
                      [repeats](Project& project) { project.mix.repeats = repeats; });
}

void MixEditor::importMap(const QString& path) {
    m_runner.submit(JobKind::Open,
                    tr("Opening %1").arg(QFileInfo(path).fileName()),
                    [this, path](JobContext&) -> Delivery {
                        auto map = readMap(path);
                        return [this, map = std::move(map)] {
                            if (!map) {
                                emit problem(inWords(map.error()));
                                return;
                            }
                            if (!m_document.project().mix.source)
                                return; // gone while the map was read
                            m_document.change(tr("Import the map"), [&](Project& project) {
                                project.mix.map = *map;
                                project.mix.mapScale = 1.0;
                            });
                        };
                    });
}

void MixEditor::exportMap(const QString& path) {
    m_runner.submit(JobKind::Picture,
                    tr("Saving the map"),
                    [this, path, map = m_document.project().mix.map](JobContext&) -> Delivery {
                        const auto saved = writeMap(map, path);
                        return [this, path, saved] {
                            if (saved)
                                emit note(tr("Saved %1").arg(QFileInfo(path).fileName()));
                            else
                                emit problem(inWords(saved.error()));
                        };
                    });
}

} // namespace txn::app
