// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Fidelity.h"

#include "bench/Exemplars.h"
#include "bench/PaperNoise.h"
#include "core/noise/NoiseGrid.h"
#include "core/samples/Samples.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/TextonSolver.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace txn::bench {
namespace {

constexpr Size kPicture{1024, 1024};
constexpr int kWindow = 64;
constexpr std::uint32_t kSeeds = 8;

/// Sums of powers of deviations from the known mean.
struct Moments {
    double count = 0.0;
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    double fourth = 0.0;

    void add(double v) {
        const double square = v * v;
        count += 1.0;
        first += v;
        second += square;
        third += square * v;
        fourth += square * square;
    }
    double mean() const { return first / count; }
    double variance() const { return second / count - mean() * mean(); }
    double excessKurtosis() const {
        const double m = mean();
        const double central = fourth / count - 4.0 * m * third / count +
                               6.0 * m * m * second / count - 3.0 * m * m * m * m;
        return central / (variance() * variance()) - 3.0;
    }
};

Gaussianity measure(const Image& picture, double mean) {
    Moments all;
    Moments variances;
    for (int top = 0; top + kWindow <= picture.height(); top += kWindow) {
        for (int left = 0; left + kWindow <= picture.width(); left += kWindow) {
            Moments window;
            for (int y = top; y < top + kWindow; ++y) {
                for (int x = left; x < left + kWindow; ++x) {
                    const double v = picture.at(x, y, 0) - mean;
                    all.add(v);
                    window.add(v);
                }
            }
            variances.add(window.variance());
        }
    }
    return {all.excessKurtosis(), std::sqrt(variances.variance()) / variances.mean()};
}

/// Its noise is the mean of the channels of the texton's noise.
Texton greyMean(const Texton& texton) {
    Texton grey = texton;
    const int channels = texton.channels();
    const auto share = 1.0F / static_cast<float>(channels);
    grey.mean = {std::accumulate(texton.mean.begin(), texton.mean.end(), 0.0) / channels};
    for (std::size_t q = 0; q < texton.kernels.size(); ++q) {
        grey.kernels[q] = Image(texton.kernels[q].size(), 1);
        const auto sum = grey.kernels[q].plane(0);
        for (int c = 0; c < channels; ++c) {
            const auto plane = texton.kernels[q].plane(c);
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += share * plane[i];
        }
    }
    return grey;
}

Texton solved(const Exemplar& exemplar) {
    const GaussianModel model(exemplar);
    auto solver = TextonSolver::create(model, {});
    while (!solver->done())
        solver->step();
    return colorCorrected(solver->texton(), model.covariance());
}

/// Names of the photographs, and their files.
constexpr std::pair<const char*, const char*> kPhotographs[] = {
    {"photo_sand", "sand_640x480.png"},
    {"photo_brass", "brass_512.png"},
    {"photo_wood", "wood_512x384.png"},
    {"photo_rock", "rock_512.png"},
    {"photo_rust", "rust_768x384.png"},
};

Texton namedTexton(const std::string& name) {
    for (const auto& [photograph, file] : kPhotographs) {
        if (name == photograph)
            return solved(*bench::photograph(file));
    }
    return solved(*makeExemplar(*makeSample(name, {512, 512}, Seed{1}), name));
}

} // namespace

Gaussianity gaussianity(const Texton& texton, const NoiseParams& params) {
    const Texton grey = greyMean(texton);
    Gaussianity mean;
    for (std::uint32_t i = 1; i <= kSeeds; ++i) {
        NoiseParams seeded = params;
        seeded.seed = Seed{i};
        const auto grid = NoiseGrid::create(grey, seeded);
        const Gaussianity one = measure(*grid->render({0, 0, kPicture}), grey.mean[0]);
        mean.kurtosis += one.kurtosis / kSeeds;
        mean.spread += one.spread / kSeeds;
    }
    return mean;
}

Fidelity fidelity(const Texton& texton) {
    const auto stratified = [&](double meanImpacts) {
        return gaussianity(texton, {NoiseProcess::Stratified, meanImpacts, {}, {}});
    };
    Fidelity result;
    result.limit = stratified(NoiseParams::kMaxMeanImpacts);
    result.paper = gaussianity(texton, {NoiseProcess::Poisson, PaperNoise::kMeanImpacts, {}, {}});
    const auto noFurther = [](double ours, double paper, double limit) {
        return std::abs(ours - limit) <= std::abs(paper - limit);
    };
    for (result.meanImpacts = 4; result.meanImpacts < NoiseParams::kMaxMeanImpacts;
         ++result.meanImpacts) {
        result.ours = stratified(result.meanImpacts);
        if (noFurther(result.ours.kurtosis, result.paper.kurtosis, result.limit.kurtosis) &&
            noFurther(result.ours.spread, result.paper.spread, result.limit.spread))
            break;
    }
    return result;
}

FidelityTable::FidelityTable() {
    for (const SampleInfo& sample : sampleCatalog())
        m_names.emplace_back(sample.name);
    for (const auto& [name, file] : kPhotographs) {
        if (bench::photograph(file))
            m_names.emplace_back(name);
    }
}

const Fidelity& FidelityTable::of(const std::string& name) {
    const auto [entry, isNew] = m_known.try_emplace(name);
    if (isNew)
        entry->second = fidelity(namedTexton(name));
    return entry->second;
}

int FidelityTable::meanImpacts() {
    int largest = 0;
    for (const std::string& name : m_names)
        largest = std::max(largest, of(name).meanImpacts);
    return largest;
}

} // namespace txn::bench
