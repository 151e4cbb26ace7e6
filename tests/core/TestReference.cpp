// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/SpotNoise.h"
#include "core/spectral/PeriodicComponent.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/RelativeModelError.h"
#include "core/texton/TextonSolver.h"
#include "tests/helpers/Arrays.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <fstream>
#include <nlohmann/json.hpp>

using namespace txn;
using namespace txn::test;
namespace fs = std::filesystem;

namespace {

/// One folder of results of the papers' authors' own functions, see shared/reference/README.md.
struct Reference {
    fs::path folder;
    nlohmann::json manifest;
    Size size;
    int channels = 0;
    int side = 0;

    explicit Reference(const QString& name) : folder(fs::path(TXN_TEST_DATA) / name.toStdString()) {
        std::ifstream(folder / "manifest.json") >> manifest;
        size = {manifest.at("width"), manifest.at("height")};
        channels = manifest.at("channels");
        side = manifest.at("support");
    }

    std::vector<double> array(const std::string& file) const { return readArray(folder / file); }
    Image domainImage(const std::string& file) const {
        return imageFromArray(array(file), size, channels);
    }
};

const char* const kFolders[] = {"synthetic_49x65_support13", "synthetic_72x54_support16"};

/// What single precision leaves after so many plain iterations. Measured: at most 1e-6 after 1,
/// 4e-6 after 5, 3e-5 after 50, where phases of tiny scalar products wander. Five times that here,
/// since other processors round elsewhere.
double coefficientTolerance(int iterations) {
    return iterations <= 1 ? 5e-6 : iterations <= 5 ? 2e-5 : 1.5e-4;
}

} // namespace

/// The results of the papers' authors' own code on two small exemplars.
class TestReference : public QObject {
    Q_OBJECT

  private slots:
    void periodicComponentAgrees_data() {
        QTest::addColumn<QString>("folder");
        for (const char* folder : kFolders)
            QTest::newRow(folder) << folder;
    }

    void periodicComponentAgrees() {
        QFETCH(QString, folder);
        const Reference reference(folder);
        const Image result = periodicComponent(reference.domainImage("exemplar.f64"));
        // Values in [0, 1]: a few roundings of single precision.
        TXN_AT_MOST(largestDifference(arrayFromImage(result), reference.array("periodic.f64")),
                    1e-6);
    }

    void textonAgrees_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<int>("index");
        for (const char* folder : kFolders) {
            const auto cases = Reference(folder).manifest.at("cases");
            QCOMPARE(static_cast<int>(cases.size()), 12);
            for (int i = 0; i < static_cast<int>(cases.size()); ++i) {
                const auto& entry = cases[static_cast<std::size_t>(i)];
                const QString tag =
                    QString("%1 %2").arg(folder, QString::fromStdString(entry.at("coefficients")));
                QTest::newRow(qPrintable(tag)) << QString(folder) << i;
            }
        }
    }

    void textonAgrees() {
        QFETCH(QString, folder);
        QFETCH(int, index);
        const Reference reference(folder);
        const auto& entry = reference.manifest.at("cases")[static_cast<std::size_t>(index)];

        const GaussianModel model(exemplarOf(reference.domainImage("exemplar.f64")));
        TextonParams params;
        params.support = entry.at("shape") == "disc"
                             ? Support::disc(reference.side)
                             : Support::rectangle({reference.side, reference.side});
        params.interpolationOrder = entry.at("order");
        params.iterations = entry.at("iterations");
        params.momentum = 0.0;
        auto solver =
            TextonSolver::create(model, params, reference.domainImage("initial_noise.f64"));
        TXN_OK(solver);
        while (!solver->done())
            solver->step();

        const double tolerance = coefficientTolerance(params.iterations);
        const Texton texton = solver->texton();
        const auto expected = reference.array(entry.at("coefficients"));
        TXN_AT_MOST(relativeError(arrayFromImage(texton.kernels.front()), expected), tolerance);
        const Texton corrected = colorCorrected(texton, model.covariance());
        const auto expectedCorrected = reference.array(entry.at("corrected"));
        TXN_AT_MOST(relativeError(arrayFromImage(corrected.kernels.front()), expectedCorrected),
                    tolerance);

        // Errors of the coefficients enter squared: measured 1.3e-7, and 1e-3 is asked for.
        constexpr double kRmeTolerance = 1e-5;
        const double rme = entry.at("rme");
        const double rmeCorrected = entry.at("rme_corrected");
        TXN_AT_MOST(std::abs(solver->relativeModelError() - rme), kRmeTolerance);
        TXN_AT_MOST(std::abs(solver->relativeModelError(corrected) - rmeCorrected), kRmeTolerance);
        const auto separate = relativeModelError(model, corrected);
        TXN_OK(separate);
        TXN_AT_MOST(std::abs(*separate - rmeCorrected), kRmeTolerance);
    }

    /// The zeros of the authors' disc are those of ours.
    void discsHaveTheSameSamples_data() { periodicComponentAgrees_data(); }

    void discsHaveTheSameSamples() {
        QFETCH(QString, folder);
        const Reference reference(folder);
        const Image coefficients =
            imageFromArray(reference.array("coefficients_disc_order1_it50.f64"),
                           {reference.side, reference.side},
                           3);
        QVERIFY(!coefficients.empty());
        const Support disc = Support::disc(reference.side);
        for (int y = 0; y < reference.side; ++y) {
            for (int x = 0; x < reference.side; ++x)
                QCOMPARE(disc.contains(x, y), coefficients.at(x, y, 0) != 0.0F);
        }
    }

    void kernelSumAgrees_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<int>("index");
        for (const char* folder : kFolders) {
            for (int i = 0; i < 3; ++i)
                QTest::addRow("%s %d", folder, i) << QString(folder) << i;
        }
    }

    void kernelSumAgrees() {
        QFETCH(QString, folder);
        QFETCH(int, index);
        const Reference reference(folder);
        const auto& entry = reference.manifest.at("noise").at(static_cast<std::size_t>(index));
        Texton texton;
        texton.interpolationOrder = entry.at("order");
        texton.support = Support::rectangle({reference.side, reference.side});
        texton.mean.assign(static_cast<std::size_t>(reference.channels), 0.0);
        texton.kernels.push_back(imageFromArray(reference.array(entry.at("coefficients")),
                                                texton.support.size(),
                                                reference.channels));
        QVERIFY(!texton.kernels.front().empty());

        const auto impulses = reference.array("impulses.f64");
        const auto points = reference.array("points.f64");
        QCOMPARE(impulses.size(), std::size_t{40 * 3});
        QCOMPARE(points.size(), std::size_t{200 * 2});
        std::vector<double> sums;
        for (std::size_t p = 0; p < points.size(); p += 2) {
            for (int c = 0; c < reference.channels; ++c) {
                double sum = 0.0;
                for (std::size_t i = 0; i < impulses.size(); i += 3)
                    sum += impulses[i + 2] * kernelValue(texton,
                                                         0,
                                                         c,
                                                         points[p] - impulses[i],
                                                         points[p + 1] - impulses[i + 1]);
                sums.push_back(sum);
            }
        }
        const auto expected = reference.array("kernel_sum_order" +
                                              std::to_string(texton.interpolationOrder) + ".f64");
        // Coefficients and weights are rounded to single precision.
        TXN_AT_MOST(relativeError(sums, expected), 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestReference)
#include "TestReference.moc"
