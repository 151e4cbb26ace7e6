// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pipeline/Pipeline.h"

#include "app/jobs/AnalysisJob.h"
#include "app/jobs/ExemplarJob.h"
#include "app/jobs/JudgementJob.h"
#include "app/jobs/TextonJob.h"
#include "app/look/Words.h"
#include "app/threads/Background.h"
#include "core/mesh/BuiltinMeshes.h"
#include "core/mesh/MeshIo.h"

#include <QFile>

namespace txn::app {

Pipeline::Pipeline(ProjectDocument& document, JobRunner& runner, QObject* parent)
    : QObject(parent), m_document(document), m_runner(runner) {
    // Several changes in one go, such as a preset's, start one job.
    m_updateSoon.setSingleShot(true);
    m_updateSoon.setInterval(0);
    connect(&m_updateSoon, &QTimer::timeout, this, &Pipeline::update);
    connect(&m_document,
            &ProjectDocument::projectChanged,
            &m_updateSoon,
            qOverload<>(&QTimer::start));
    // Queued: in the middle of an update, the texton's job is still to come.
    connect(&m_runner,
            &JobRunner::jobsChanged,
            this,
            &Pipeline::updateVerdict,
            Qt::QueuedConnection);
    connect(&m_runner, &JobRunner::jobsChanged, this, &Pipeline::stateChanged);
}

/// Where the two exemplars have changed places, so have their results.
void Pipeline::swapExemplars() {
    const Project& project = m_document.project();
    if (!m_exemplar.value || !m_second.value || m_exemplar.isStale() || m_second.isStale() ||
        m_exemplar.made != ExemplarKey{project.mix.source, project.mix.edit} ||
        m_second.made != ExemplarKey{project.source, project.edit} ||
        m_exemplar.made == m_second.made)
        return;
    std::swap(m_exemplar, m_second);
    // So has their mixture: nothing is computed, and the noise stays as it is.
    if (m_mix.value && m_mix.value == m_finishedMix && !m_mix.isStale()) {
        m_finishedMix = reversed(*m_finishedMix);
        m_mix.value = m_finishedMix;
        std::swap(m_finishedMixOf.a, m_finishedMixOf.b);
        std::swap(m_mix.made->input.a, m_mix.made->input.b);
        m_mix.wanted = m_mix.made;
        emit mixChanged();
    }
    emit exemplarChanged();
    emit secondExemplarChanged();
}

void Pipeline::update() {
    dropKeptOfOthers();
    swapExemplars();
    updateExemplar();
    updateGaussian();
    updateTexton();
    updateSecondExemplar();
    updateMix();
    updateMixture();
    updateVerdict();
    updateMesh();
    updateNoiseTexton();
    updateAnalysis();
    emit stateChanged();
}

void Pipeline::fail(const Error& error) {
    if (error.code != ErrorCode::Cancelled)
        emit failed(inWords(error));
}

void Pipeline::updateExemplar() {
    const Project& project = m_document.project();
    updateExemplar(JobKind::Exemplar,
                   tr("Preparing the exemplar"),
                   m_exemplar,
                   {project.source, project.edit},
                   &Pipeline::exemplarChanged);
}

/// Either of them: no source, no exemplar.
void Pipeline::updateExemplar(JobKind kind,
                              const QString& title,
                              Stage<ExemplarKey, ExemplarResult>& stage,
                              const ExemplarKey& key,
                              void (Pipeline::*changed)()) {
    if (!key.source) {
        if (drop(kind, stage))
            emit(this->*changed)();
        return;
    }
    if (!stage.want(key))
        return;
    if (stage.made == key) { // undone before the new one was there
        m_runner.cancel(kind);
        return;
    }
    m_runner.submit(kind, title, [this, &stage, key, changed](JobContext& context) -> Delivery {
        auto result = makeExemplarResult(key.source, key.edit, context);
        return [this, &stage, key, changed, result = std::move(result)] {
            if (!result) {
                fail(result.error());
                return;
            }
            stage.set(key, *result);
            emit(this->*changed)();
            update();
        };
    });
}

void Pipeline::updateGaussian() {
    if (!m_exemplar.value) {
        if (drop(JobKind::Gaussian, m_gaussian))
            emit gaussianChanged();
        return;
    }
    if (m_exemplar.isStale())
        return; // soon there is another exemplar
    const GaussianKey key{m_exemplar.value, m_document.project().gaussian};
    if (!m_gaussian.want(key))
        return;
    if (m_gaussian.made == key) {
        m_runner.cancel(JobKind::Gaussian);
        return;
    }
    m_runner.submit(
        JobKind::Gaussian,
        tr("Making the Gaussian version"),
        [this, key](JobContext& context) -> Delivery {
            auto result =
                freedInBackground(std::make_shared<const GaussianResult>(GaussianResult{mapPictures(
                    sampleGaussian(key.exemplar->model, key.settings.method, key.settings.seed),
                    key.exemplar->exemplar.maps)}));
            if (context.cancelled())
                return {};
            return [this, key, result = std::move(result)] {
                m_gaussian.set(key, result);
                emit gaussianChanged();
                update();
            };
        });
}

void Pipeline::updateTexton() {
    const Project& project = m_document.project();
    if (project.importedTexton) {
        const TextonKey key{nullptr, project.importedTexton, {}, 0};
        if (m_texton.want(key)) {
            m_runner.cancel(JobKind::Texton);
            m_texton.set(key, importedTexton(*project.importedTexton));
            m_finishedTexton = m_texton.value;
            updateNoiseTexton();
            emit textonChanged();
        }
        return;
    }
    if (!m_exemplar.value) {
        if (drop(JobKind::Texton, m_texton)) {
            m_finishedTexton.reset();
            updateNoiseTexton();
            emit textonChanged();
        }
        return;
    }
    if (m_exemplar.isStale())
        return;
    const TextonKey key{m_exemplar.value, nullptr, project.texton, m_attempt};
    if (!m_texton.want(key))
        return;
    if (m_texton.made == key) { // undone before the new one was there
        cancelTexton();
        return;
    }
    m_runner.submit(
        JobKind::Texton,
        tr("Computing the texton"),
        [this, key](JobContext& context) -> Delivery {
            const auto show = [this](const std::shared_ptr<const TextonResult>& result) {
                m_texton.value = result;
                updateNoiseTexton();
                emit textonChanged();
            };
            auto result = computeTexton(
                *key.exemplar,
                key.settings,
                context,
                [&](std::shared_ptr<const TextonResult> partial) {
                    context.deliver([show, partial = std::move(partial)] { show(partial); });
                });
            return [this, key, show, result = std::move(result)] {
                if (!result) {
                    fail(result.error());
                    return;
                }
                m_texton.set(key, *result);
                m_finishedTexton = *result;
                show(*result);
                update();
            };
        });
}

void Pipeline::cancelTexton() {
    m_runner.cancel(JobKind::Texton);
    // An unfinished texton belongs to the job: the last whole one comes back.
    if (m_texton.value != m_finishedTexton) {
        m_texton.value = m_finishedTexton;
        updateNoiseTexton();
        emit textonChanged();
    }
    emit stateChanged();
}

void Pipeline::recomputeTexton() {
    ++m_attempt;
    // What failed or was stopped is tried again, too.
    retry(JobKind::Exemplar, m_exemplar);
    retry(JobKind::Gaussian, m_gaussian);
    retry(JobKind::SecondExemplar, m_second);
    retry(JobKind::Mix, m_mix);
    retry(JobKind::Verdict, m_verdict);
    retry(JobKind::Analysis, m_analysis);
    retry(JobKind::Mesh, m_mesh);
    update();
}

void Pipeline::updateSecondExemplar() {
    const Project& project = m_document.project();
    updateExemplar(JobKind::SecondExemplar,
                   tr("Preparing the second exemplar"),
                   m_second,
                   {project.source ? project.mix.source : nullptr, project.mix.edit},
                   &Pipeline::secondExemplarChanged);
}

void Pipeline::updateMix() {
    if (!m_second.value || !m_exemplar.value) {
        if (drop(JobKind::Mix, m_mix)) {
            m_finishedMix.reset();
            m_finishedMixOf = {};
            emit mixChanged();
        }
        return;
    }
    if (m_exemplar.isStale() || m_second.isStale())
        return; // soon there is another one
    const Project& project = m_document.project();
    const MixKey key{{m_exemplar.value, m_second.value, project.texton}, project.mix.textons};
    if (!m_mix.want(key))
        return;
    if (m_mix.made == key) { // undone before the new one was there
        cancelMix();
        return;
    }
    const auto known = m_finishedMixOf == key.input ? m_finishedMix : nullptr;
    m_runner.submit(JobKind::Mix,
                    tr("Computing the textons from A to B"),
                    [this, key, known](JobContext& context) -> Delivery {
                        auto result =
                            computeMix(key.input,
                                       key.textons,
                                       known,
                                       context,
                                       [&](std::shared_ptr<const MixResult> partial) {
                                           context.deliver([this, partial = std::move(partial)] {
                                               m_mix.value = partial;
                                               emit mixChanged();
                                           });
                                       });
                        return [this, key, result = std::move(result)] {
                            if (!result) {
                                fail(result.error());
                                cancelMix();
                                return;
                            }
                            m_mix.set(key, *result);
                            m_finishedMix = *result;
                            m_finishedMixOf = key.input;
                            updateMixture();
                            emit mixChanged();
                        };
                    });
}

void Pipeline::previewMap(std::shared_ptr<const MixingMap> map) {
    m_previewEnds = map == nullptr;
    if (m_previewEnds) {
        m_updateSoon.start(); // not the map before the stroke for an instant
        return;
    }
    m_previewMap = std::move(map);
    emit mixtureChanged();
}

void Pipeline::cancelMix() {
    m_runner.cancel(JobKind::Mix);
    if (m_mix.value != m_finishedMix) {
        m_mix.value = m_finishedMix;
        emit mixChanged();
    }
    emit stateChanged();
}

void Pipeline::updateMixture() {
    const Project& project = m_document.project();
    const MixLook look{m_finishedMix, project.noise.contrast, project.noise.brightness};
    bool changed = m_mixLook != look;
    if (changed) {
        m_mixTextons.reset();
        if (look.mix) {
            auto textons = std::make_shared<std::vector<Texton>>();
            for (const MixedTexton& one : look.mix->mixed.textons)
                textons->push_back(
                    adjusted(one.texton, look.mix->maps, look.contrast, look.brightness));
            m_mixTextons = std::move(textons);
        }
        m_mixLook = look; // only now: without memory for it, the next update tries again
    }
    if (m_previewEnds) {
        m_previewMap.reset();
        m_previewEnds = false;
    }
    const MapLook map{project.mix.map, mapPlacement(project.mix), project.mix.repeats};
    if (m_mapLook != map) {
        auto made = std::make_shared<MixingMap>();
        made->rho = map.map.image();
        made->placement = map.placement;
        made->boundary = map.repeats ? MapBoundary::Repeat : MapBoundary::Clamp;
        m_mixingMap = std::move(made);
        m_mapLook = map;
        changed = true;
    }
    changed = changed || m_shownMap != mixingMap();
    m_shownMap = mixingMap();
    if (changed)
        emit mixtureChanged();
}

void Pipeline::updateVerdict() {
    if (!m_exemplar.value) {
        if (drop(JobKind::Verdict, m_verdict))
            emit verdictChanged();
        return;
    }
    if (m_runner.isBusy(JobKind::Texton))
        return; // on a core of its own it is there much earlier; advice comes after it
    const auto key = m_exemplar.value;
    if (!m_verdict.want(key))
        return;
    if (m_verdict.made == key) {
        m_runner.cancel(JobKind::Verdict);
        return;
    }
    m_runner.submit(JobKind::Verdict,
                    tr("Judging the exemplar"),
                    [this, key](JobContext& context) -> Delivery {
                        auto result = judge(*key, context);
                        return [this, key, result = std::move(result)] {
                            m_verdict.set(key, result);
                            emit verdictChanged();
                        };
                    });
}

std::shared_ptr<const Suitability> Pipeline::verdict() const {
    if (!m_verdict.value || !m_verdict.value->suitability)
        return nullptr;
    return {m_verdict.value, &*m_verdict.value->suitability};
}

std::optional<SupportSuggestion> Pipeline::suggestedSupport() const {
    return m_verdict.value ? m_verdict.value->support : std::nullopt;
}

void Pipeline::setAnalysisWanted(bool wanted) {
    m_analysisWanted = wanted;
    if (wanted)
        updateAnalysis();
}

void Pipeline::updateAnalysis() {
    if (!m_exemplar.value) {
        if (drop(JobKind::Analysis, m_analysis))
            emit analysisChanged();
        return;
    }
    if (!m_analysisWanted || !m_gaussian.value || !m_texton.value || !m_texton.value->finished)
        return;
    const NoiseSettings& noise = m_document.project().noise;
    const AnalysisKey key{m_exemplar.value,
                          m_gaussian.value,
                          m_noiseTexton,
                          noise.process,
                          noise.meanImpacts,
                          noise.seed};
    if (!m_analysis.want(key))
        return;
    if (m_analysis.made == key) {
        m_runner.cancel(JobKind::Analysis);
        return;
    }
    m_runner.submit(JobKind::Analysis,
                    tr("Measuring spectra"),
                    [this, key](JobContext& context) -> Delivery {
                        auto result =
                            analyseAll(*key.exemplar,
                                       *key.gaussian,
                                       *key.texton,
                                       {key.process, key.meanImpacts, key.seed, std::nullopt},
                                       context);
                        return [this, key, result = std::move(result)] {
                            if (!result) {
                                fail(result.error());
                                return;
                            }
                            m_analysis.set(key, *result);
                            emit analysisChanged();
                        };
                    });
}

void Pipeline::updateMesh() {
    const NoiseSettings& noise = m_document.project().noise;
    if (noise.scene != NoiseScene::Mesh && noise.scene != NoiseScene::Surface)
        return;
    const QString key = noise.mesh;
    if (!m_mesh.want(key))
        return;
    if (m_mesh.made == key) {
        m_runner.cancel(JobKind::Mesh);
        return;
    }
    m_runner.submit(JobKind::Mesh, tr("Loading the mesh"), [this, key](JobContext&) -> Delivery {
        auto builtin = builtinMesh(key.toStdString());
        auto mesh = builtin ? Result<TriangleMesh>(std::move(*builtin))
                            : loadMesh(QFile::encodeName(key).toStdString());
        if (!mesh)
            return [this, error = mesh.error()] { fail(error); };
        auto shared = std::make_shared<const TriangleMesh>(std::move(*mesh));
        return [this, key, shared = std::move(shared)] {
            m_mesh.set(key, shared);
            emit meshChanged();
        };
    });
}

void Pipeline::updateNoiseTexton() {
    const NoiseSettings& noise = m_document.project().noise;
    const auto shown = shownTexton();
    if (m_noiseTextonOf == shown && m_contrast == noise.contrast &&
        m_brightness == noise.brightness)
        return;
    const bool sameLook = m_contrast == noise.contrast && m_brightness == noise.brightness;
    m_noiseTextonOf = shown;
    m_contrast = noise.contrast;
    m_brightness = noise.brightness;
    m_noiseTexton = noiseOf(shown);
    if (!sameLook)
        m_keptNoiseTexton = noiseOf(m_kept);
    emit noiseTextonChanged();
}

std::shared_ptr<const Texton>
Pipeline::noiseOf(const std::shared_ptr<const TextonResult>& result) const {
    if (!result)
        return nullptr;
    const NoiseSettings& noise = m_document.project().noise;
    return std::make_shared<const Texton>(
        adjusted(result->texton, result->maps, noise.contrast, noise.brightness));
}

std::shared_ptr<const Texton> Pipeline::presentNoiseTexton() const {
    return isShowingKept() ? noiseOf(m_texton.value) : m_noiseTexton;
}

/// A texton of another material would be taken for one of this.
void Pipeline::dropKeptOfOthers() {
    const Project& project = m_document.project();
    if (!m_kept || (m_keptOf.first == project.source && m_keptOf.second == project.importedTexton))
        return;
    m_kept.reset();
    m_keptNoiseTexton.reset();
    showKept(false);
}

void Pipeline::keepTexton() {
    if (m_finishedTexton) {
        m_kept = m_finishedTexton;
        m_keptNoiseTexton = noiseOf(m_kept);
        m_keptOf = {m_document.project().source, m_document.project().importedTexton};
    }
    showKept(false);
}

void Pipeline::showKept(bool kept) {
    m_showKept = kept && m_kept;
    updateNoiseTexton();
    emit stateChanged();
}

std::shared_ptr<const TextonResult> Pipeline::shownTexton() const {
    return isShowingKept() ? m_kept : m_texton.value;
}

bool Pipeline::isStale(Picture picture) const {
    const bool exemplar = m_exemplar.isStale();
    switch (picture) {
    case Picture::Exemplar:
        return exemplar;
    case Picture::Gaussian:
        return exemplar || m_gaussian.isStale();
    case Picture::Noise:
        if (m_document.project().mix.source && isMixStale())
            return true;
        break;
    case Picture::Texton:
        break;
    }
    return exemplar || m_texton.isStale();
}

} // namespace txn::app
