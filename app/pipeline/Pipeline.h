// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"
#include "app/jobs/JobRunner.h"
#include "app/jobs/MixJob.h"
#include "app/jobs/Results.h"
#include "app/pipeline/Stage.h"

#include <QObject>
#include <QTimer>
#include <utility>

namespace txn::app {

/// Hears of changes to the project, starts the jobs whose results they make stale, and keeps the
/// newest results. What is stale stays on show until its successor comes. Interface thread.
class Pipeline : public QObject {
    Q_OBJECT

  public:
    Pipeline(ProjectDocument& document, JobRunner& runner, QObject* parent = nullptr);

    // Null where there is nothing (yet).
    std::shared_ptr<const ExemplarResult> exemplar() const { return m_exemplar.value; }
    std::shared_ptr<const GaussianResult> gaussian() const { return m_gaussian.value; }
    std::shared_ptr<const TextonResult> texton() const { return m_texton.value; }

    /// A finished texton can be kept as A, to be seen in place of the present one (B) and back.
    void keepTexton();
    std::shared_ptr<const TextonResult> keptTexton() const { return m_kept; }
    void showKept(bool kept);
    bool isShowingKept() const { return m_showKept && m_kept; }
    /// The kept one with the noise's contrast and brightness.
    std::shared_ptr<const Texton> keptNoiseTexton() const { return m_keptNoiseTexton; }
    /// texton(), or the kept one while that is shown.
    std::shared_ptr<const TextonResult> shownTexton() const;

    // Of a mixture with a second exemplar; null where there is none (yet).
    std::shared_ptr<const ExemplarResult> secondExemplar() const { return m_second.value; }
    /// While it is computed, with the textons so far.
    std::shared_ptr<const MixResult> mix() const { return m_mix.value; }
    /// All textons of the newest whole mixture, with the noise's contrast and brightness.
    std::shared_ptr<const std::vector<Texton>> mixTextons() const { return m_mixTextons; }
    /// The project's map, ready for the noise.
    std::shared_ptr<const MixingMap> mixingMap() const {
        return m_previewMap ? m_previewMap : m_mixingMap;
    }
    /// Another one takes its place while a stroke is drawn; null: no longer.
    void previewMap(std::shared_ptr<const MixingMap> map);
    /// Whether mixTextons() are not (yet) what the project asks for.
    bool isMixStale() const {
        return m_exemplar.isStale() || m_second.isStale() || m_mix.isStale();
    }
    bool isComputingMix() const {
        return m_runner.isBusy(JobKind::Mix) || m_runner.isBusy(JobKind::SecondExemplar) ||
               m_runner.isBusy(JobKind::Exemplar);
    }
    /// Drops the textons on their way and goes back to the last whole mixture.
    void cancelMix();

    std::shared_ptr<const Suitability> verdict() const;
    std::optional<SupportSuggestion> suggestedSupport() const;
    std::shared_ptr<const AnalysisResult> analysis() const { return m_analysis.value; }
    std::shared_ptr<const TriangleMesh> mesh() const { return m_mesh.value; }

    /// shownTexton() with the noise's contrast and brightness: what noise on screen is made
    /// of.
    std::shared_ptr<const Texton> noiseTexton() const { return m_noiseTexton; }

    /// What noiseTexton() was made of: shownTexton(), or the one before it for an instant.
    std::shared_ptr<const TextonResult> noiseTextonSource() const { return m_noiseTextonOf; }
    /// texton() with the noise's contrast and brightness, whatever is shown: for exports.
    std::shared_ptr<const Texton> presentNoiseTexton() const;

    /// Whether what is shown is not (yet) what the project asks for.
    bool isStale(Picture picture) const;
    bool isComputingTexton() const { return m_runner.isBusy(JobKind::Texton); }
    /// Drops the texton on its way and goes back to the last finished one.
    void cancelTexton();
    /// After a cancel, or to see it form again.
    void recomputeTexton();
    /// The spectra are computed only while somebody looks at them.
    void setAnalysisWanted(bool wanted);

  signals:
    void exemplarChanged();
    void gaussianChanged();
    void textonChanged();
    void noiseTextonChanged();
    void secondExemplarChanged();
    void mixChanged();
    /// mixTextons() or mixingMap().
    void mixtureChanged();
    void verdictChanged();
    void analysisChanged();
    void meshChanged();
    /// Something began, ended, or got stale.
    void stateChanged();
    /// One line for the message bar.
    void failed(const QString& message);

  private:
    void update();
    void updateExemplar();
    void updateGaussian();
    void updateTexton();
    void swapExemplars();
    void updateSecondExemplar();
    void updateMix();
    void updateMixture();
    void updateVerdict();
    void updateAnalysis();
    void updateMesh();
    void updateNoiseTexton();
    void dropKeptOfOthers();
    std::shared_ptr<const Texton> noiseOf(const std::shared_ptr<const TextonResult>& result) const;
    void fail(const Error& error);
    template <class Key, class Value>
    void retry(JobKind kind, Stage<Key, Value>& stage) {
        if (stage.isStale() && !m_runner.isBusy(kind))
            stage.wanted = stage.made;
    }
    /// Empties a stage whose input has gone, and stops its job. Whether there was anything.
    template <class Key, class Value>
    bool drop(JobKind kind, Stage<Key, Value>& stage) {
        m_runner.cancel(kind);
        const bool was = stage.value || stage.wanted;
        stage.clear();
        return was;
    }

    struct ExemplarKey {
        std::shared_ptr<const Source> source;
        ExemplarEdit edit;
        bool operator==(const ExemplarKey&) const = default;
    };
    struct GaussianKey {
        std::shared_ptr<const ExemplarResult> exemplar;
        GaussianSettings settings;
        bool operator==(const GaussianKey&) const = default;
    };
    struct TextonKey {
        std::shared_ptr<const ExemplarResult> exemplar;
        std::shared_ptr<const TextonAsset> imported;
        TextonSettings settings;
        int attempt = 0; ///< so that the same texton can be asked for again
        bool operator==(const TextonKey&) const = default;
    };
    struct MixKey {
        MixInput input;
        int textons = 0;
        bool operator==(const MixKey&) const = default;
    };
    /// What mixTextons() were made of.
    struct MixLook {
        std::shared_ptr<const MixResult> mix;
        double contrast = 1.0;
        double brightness = 0.0;
        bool operator==(const MixLook&) const = default;
    };
    /// What mixingMap() was made of.
    struct MapLook {
        PaintedMap map;
        MapPlacement placement;
        bool repeats = false;
        bool operator==(const MapLook&) const = default;
    };
    struct AnalysisKey {
        std::shared_ptr<const ExemplarResult> exemplar;
        std::shared_ptr<const GaussianResult> gaussian;
        std::shared_ptr<const Texton> texton;
        NoiseProcess process{};
        double meanImpacts = 0.0;
        Seed seed;
        bool operator==(const AnalysisKey&) const = default;
    };

    void updateExemplar(JobKind kind,
                        const QString& title,
                        Stage<ExemplarKey, ExemplarResult>& stage,
                        const ExemplarKey& key,
                        void (Pipeline::*changed)());

    ProjectDocument& m_document;
    JobRunner& m_runner;
    QTimer m_updateSoon;

    Stage<ExemplarKey, ExemplarResult> m_exemplar;
    Stage<GaussianKey, GaussianResult> m_gaussian;
    Stage<TextonKey, TextonResult> m_texton;
    Stage<ExemplarKey, ExemplarResult> m_second;
    Stage<MixKey, MixResult> m_mix;
    std::shared_ptr<const MixResult> m_finishedMix;
    MixInput m_finishedMixOf;
    std::shared_ptr<const std::vector<Texton>> m_mixTextons;
    MixLook m_mixLook;
    std::shared_ptr<const MixingMap> m_mixingMap;
    std::shared_ptr<const MixingMap> m_previewMap;
    bool m_previewEnds = false;                  ///< as soon as the project's map is ready
    std::shared_ptr<const MixingMap> m_shownMap; ///< that mixtureChanged() last told of
    std::optional<MapLook> m_mapLook;
    Stage<std::shared_ptr<const ExemplarResult>, Judgement> m_verdict;
    Stage<AnalysisKey, AnalysisResult> m_analysis;
    Stage<QString, TriangleMesh> m_mesh;
    std::shared_ptr<const TextonResult> m_finishedTexton;
    std::shared_ptr<const TextonResult> m_kept;
    std::shared_ptr<const Texton> m_keptNoiseTexton;
    std::pair<std::shared_ptr<const Source>, std::shared_ptr<const TextonAsset>> m_keptOf;
    bool m_showKept = false;
    std::shared_ptr<const Texton> m_noiseTexton;
    std::shared_ptr<const TextonResult> m_noiseTextonOf;
    double m_contrast = 1.0;
    double m_brightness = 0.0;
    int m_attempt = 0;
    bool m_analysisWanted = false;
};

} // namespace txn::app
