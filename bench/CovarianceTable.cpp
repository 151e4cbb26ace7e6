// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the table of docs/FIDELITY.md to standard output and, into a folder, a sheet for every
// material: script/fidelity.
#include "bench/Exemplars.h"
#include "core/gaussian/GaussianSampler.h"
#include "core/image/ImageGeometry.h"
#include "core/image/ImageIo.h"
#include "core/noise/NoiseGrid.h"
#include "core/qa/Autocovariance.h"
#include "core/qa/KernelChoice.h"
#include "core/samples/Samples.h"
#include "core/sheet/ContactSheet.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/TextonSolver.h"

#include <chrono>
#include <cstdio>

using namespace txn;

namespace {

constexpr Size kSampleSize{512, 512};
constexpr int kSheetSide = 64;

/// What was found, and how long that took.
struct Timed {
    Texton texton;
    double seconds = 0.0;
};

template <class Find>
std::optional<Timed> timed(const GaussianModel& model, Find find) {
    const auto start = std::chrono::steady_clock::now();
    auto texton = find();
    if (!texton)
        return std::nullopt;
    Timed result{colorCorrected(*texton, model.covariance()), 0.0};
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

/// [TN17] algorithm 1 as it stands: 50 plain iterations.
std::optional<Timed> byThePapers(const GaussianModel& model, int side) {
    return timed(model, [&]() -> std::optional<Texton> {
        TextonParams params;
        params.support = Support::rectangle({side, side});
        params.momentum = 0.0;
        auto solver = TextonSolver::create(model, params);
        if (!solver)
            return std::nullopt;
        while (!solver->done())
            solver->step();
        return solver->texton();
    });
}

LeastSquaresParams fitOf(int side, int kernels) {
    LeastSquaresParams params;
    params.support = Support::rectangle({side, side});
    params.kernels = kernels;
    return params;
}

std::optional<Timed> byFit(const GaussianModel& model, int side, int kernels) {
    return timed(model, [&]() -> std::optional<Texton> {
        auto fitted = fitTexton(model, fitOf(side, kernels));
        return fitted ? std::optional(std::move(*fitted)) : std::nullopt;
    });
}

/// The number of kernels is chosen inside the exemplar given.
std::optional<Timed> byAutoFit(const Exemplar& exemplar, const GaussianModel& model, int side) {
    return timed(model, [&]() -> std::optional<Texton> {
        const auto choice = chooseKernels(exemplar, true, fitOf(side, 1));
        if (!choice)
            return std::nullopt;
        auto fitted = fitTexton(model, fitOf(side, choice->kernels));
        return fitted ? std::optional(std::move(*fitted)) : std::nullopt;
    });
}

void printCell(const std::optional<Timed>& found, const Autocovariance& unseen, bool kernels) {
    if (!found) {
        std::printf(" – |");
        return;
    }
    const int lag = unseen.maxLag();
    const double error =
        autocovariance(found->texton, lag).distance(unseen, lag) / unseen.norm(lag);
    std::printf(" %.3f, %.2f s", error, found->seconds);
    if (kernels)
        std::printf(", Q = %d", found->texton.kernelCount());
    std::printf(" |");
}

void printRows(const Exemplar& whole) {
    const Image& image = whole.image;
    const Size half{image.width() / 2, image.height()};
    const auto left = makeExemplar(*crop(image, {0, 0, half}), whole.name);
    const Image right = *crop(image, {image.width() - half.width, 0, half});
    const GaussianModel model(*left);
    for (const int side : {32, 64, 128}) {
        if (half.width < side || half.height < side)
            continue;
        const int lag = side / 2;
        const auto unseen = autocovariance(right, lag);
        const double floor =
            autocovariance(left->image, lag).distance(unseen, lag) / unseen.norm(lag);
        std::printf("| %s | %d | %d | %.3f |", whole.name.c_str(), image.channels(), side, floor);
        printCell(byThePapers(model, side), unseen, false);
        for (const int kernels : {1, 2, 4})
            printCell(byFit(model, side, kernels), unseen, false);
        printCell(byAutoFit(*left, model, side), unseen, true);
        std::printf("\n");
        std::fflush(stdout);
    }
}

Image noiseOf(const Texton& texton, NoiseProcess process, double meanImpacts, Size size) {
    NoiseParams params;
    params.process = process;
    params.meanImpacts = meanImpacts;
    return *NoiseGrid::create(texton, params, 1.0)->render({0, 0, size});
}

void writeSheet(const Exemplar& exemplar, const std::filesystem::path& folder) {
    const GaussianModel model(exemplar);
    const Size size = exemplar.image.size();
    if (std::min(size.width, size.height) < kSheetSide)
        return;
    const auto papers = byThePapers(model, kSheetSide);
    const auto fitted = byAutoFit(exemplar, model, kSheetSide);
    if (!papers || !fitted)
        return;
    const Panel panels[] = {
        {"Exemplar", exemplar.image},
        {"Gaussian version", sampleGaussian(model, GaussianMethod::Adsn, Seed{1})},
        {"Papers' method, Poisson, MNI 30",
         noiseOf(papers->texton, NoiseProcess::Poisson, 30.0, size)},
        {"Fit, stratified, MNI 10", noiseOf(fitted->texton, NoiseProcess::Stratified, 10.0, size)},
        {"Papers' method, Poisson, MNI 6",
         noiseOf(papers->texton, NoiseProcess::Poisson, 6.0, size)},
        {"Fit, stratified, MNI 6", noiseOf(fitted->texton, NoiseProcess::Stratified, 6.0, size)}};
    const auto sheet = contactSheet(exemplar.name, panels);
    const auto file = folder / (exemplar.name + ".png");
    if (!sheet || !saveImage(*sheet, file))
        std::fprintf(stderr, "%s was not written\n", file.c_str());
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: txn_fidelity FOLDER\n", stderr);
        return 2;
    }
    std::vector<Exemplar> all;
    for (const SampleInfo& sample : sampleCatalog())
        all.push_back(*makeExemplar(*makeSample(sample.name, kSampleSize, Seed{1}),
                                    std::string(sample.name) + " (generated)"));
    for (const char* file : {"sand_640x480.png",
                             "rock_512.png",
                             "wood_512x384.png",
                             "brass_512.png",
                             "rust_768x384.png",
                             "leaves_509x383.png",
                             "concrete_nearwhite_512.png",
                             "gravel_gray8_512.png",
                             "sandheight_gray16_512.png",
                             "granite_palette_128.png",
                             "lawn_hdr_384x288.exr",
                             "veneer_normal_rgb16_512.png",
                             "grass_stack/grass_basecolor.png",
                             "gingham_stack/gingham_basecolor.png"}) {
        if (auto exemplar = bench::photograph(file))
            all.push_back(std::move(*exemplar));
        else
            std::fprintf(stderr, "%s is not here\n", file);
    }
    std::printf(
        "| material | channels | support | halves differ by | papers | fit, Q = 1 | fit, Q = 2 "
        "| fit, Q = 4 | fit, auto |\n|---|---|---|---|---|---|---|---|---|\n");
    for (Exemplar& exemplar : all) {
        std::ranges::replace(exemplar.name, '/', '_');
        printRows(exemplar);
        writeSheet(exemplar, argv[1]);
    }
    return 0;
}
