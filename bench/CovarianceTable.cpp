// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the tables of docs/FIDELITY.md to standard output; into one folder a sheet for every
// material, into another one a row of pictures for every generated one: script/fidelity.
#include "bench/Exemplars.h"
#include "core/compute/ComputeTexton.h"
#include "core/gaussian/ChannelWeights.h"
#include "core/gaussian/GaussianSampler.h"
#include "core/image/ImageGeometry.h"
#include "core/image/ImageIo.h"
#include "core/material/MapStack.h"
#include "core/noise/NoiseGrid.h"
#include "core/qa/Autocovariance.h"
#include "core/qa/CovarianceError.h"
#include "core/samples/Samples.h"
#include "core/sheet/ContactSheet.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/TextonSolver.h"

#include <chrono>
#include <cstdio>
#include <span>
#include <string_view>

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

/// By least squares; unset: a number of kernels that is chosen inside the exemplar given.
std::optional<Timed>
byFit(const Exemplar& exemplar, const GaussianModel& model, int side, std::optional<int> kernels) {
    return timed(model, [&]() -> std::optional<Texton> {
        ComputeParams params;
        params.support = Support::rectangle({side, side});
        params.kernels = kernels;
        params.colorCorrection = false; // timed() does that for all methods
        auto computed = computeTexton(exemplar, model, params);
        return computed ? std::optional(std::move(computed->texton)) : std::nullopt;
    });
}

void printCell(const std::optional<Timed>& found,
               const Autocovariance& unseen,
               const std::vector<double>& weights,
               bool kernels) {
    if (!found) {
        std::printf(" – |");
        return;
    }
    const int lag = unseen.maxLag();
    const double error =
        autocovariance(found->texton, lag).weighted(weights).distance(unseen, lag) /
        unseen.norm(lag);
    std::printf(" %.3f, %.2f s", error, found->seconds);
    if (kernels)
        std::printf(", Q = %d", found->texton.kernelCount());
    std::printf(" |");
}

void printRows(const Exemplar& whole) {
    const Image& image = whole.image;
    const Size half{image.width() / 2, image.height()};
    const auto left = makeExemplar(*crop(image, {0, 0, half}), whole.name, whole.maps);
    const auto weights = channelWeights(*left);
    const Image right = *crop(image, {image.width() - half.width, 0, half});
    const GaussianModel model(*left);
    for (const int side : {32, 64, 128}) {
        if (half.width < side || half.height < side)
            continue;
        const int lag = side / 2;
        const auto unseen = autocovariance(right, lag).weighted(weights);
        const double floor =
            autocovariance(left->image, lag).weighted(weights).distance(unseen, lag) /
            unseen.norm(lag);
        std::printf("| %s | %d | %d | %.3f |", whole.name.c_str(), image.channels(), side, floor);
        printCell(byThePapers(model, side), unseen, weights, false);
        for (const int kernels : {1, 2, 4})
            printCell(byFit(*left, model, side, kernels), unseen, weights, false);
        printCell(byFit(*left, model, side, {}), unseen, weights, true);
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

/// The middles of the pictures, side by side.
Image rowOf(std::span<const Image> pictures) {
    constexpr int kSide = 256;
    constexpr int kGap = 8;
    const auto count = static_cast<int>(pictures.size());
    Image row({count * (kSide + kGap) - kGap, kSide}, 3, 1.0F);
    for (int i = 0; i < count; ++i) {
        const Image& from = pictures[static_cast<std::size_t>(i)];
        const int left = (from.width() - kSide) / 2;
        const int top = (from.height() - kSide) / 2;
        for (int c = 0; c < 3; ++c) {
            for (int y = 0; y < kSide; ++y)
                std::ranges::copy(
                    from.row(c, top + y).subspan(static_cast<std::size_t>(left), kSide),
                    row.row(c, y).begin() + i * (kSide + kGap));
        }
    }
    return row;
}

void writeSheet(const Exemplar& exemplar,
                const std::filesystem::path& folder,
                const std::filesystem::path& rows) {
    const GaussianModel model(exemplar);
    const Size size = exemplar.image.size();
    if (std::min(size.width, size.height) < kSheetSide)
        return;
    const auto papers = byThePapers(model, kSheetSide);
    const auto fitted = byFit(exemplar, model, kSheetSide, {});
    if (!papers || !fitted)
        return;
    const Image gaussian = sampleGaussian(model, GaussianMethod::Adsn, Seed{1});
    const Image pictures[] = {exemplar.image,
                              gaussian,
                              noiseOf(papers->texton, NoiseProcess::Poisson, 30.0, size),
                              noiseOf(fitted->texton, NoiseProcess::Stratified, 10.0, size),
                              noiseOf(papers->texton, NoiseProcess::Poisson, 6.0, size),
                              noiseOf(fitted->texton, NoiseProcess::Stratified, 6.0, size)};
    constexpr std::string_view kGenerated = " (generated)";
    if (const auto at = exemplar.name.find(kGenerated); at != std::string::npos) {
        const auto file = rows / ("fidelity_" + exemplar.name.substr(0, at) + ".jpg");
        if (!saveImage(rowOf(std::span(pictures).first(4)), file))
            std::fprintf(stderr, "%s was not written\n", file.c_str());
    }
    const char* const labels[] = {"Exemplar",
                                  "Gaussian version",
                                  "Papers' method, Poisson, MNI 30",
                                  "Fit, stratified, MNI 10",
                                  "Papers' method, Poisson, MNI 6",
                                  "Fit, stratified, MNI 6"};
    std::vector<Panel> panels;
    for (std::size_t m = 0; m < std::max<std::size_t>(exemplar.maps.size(), 1); ++m) {
        for (std::size_t i = 0; i < std::size(pictures); ++i)
            panels.push_back(
                {exemplar.maps.empty() ? labels[i] : exemplar.maps[m].name + ": " + labels[i],
                 exemplar.maps.empty() ? pictures[i] : mapPicture(pictures[i], exemplar.maps, m)});
    }
    const auto sheet = contactSheet(exemplar.name, panels);
    const auto file = folder / (exemplar.name + ".png");
    if (!sheet || !saveImage(*sheet, file))
        std::fprintf(stderr, "%s was not written\n", file.c_str());
}

/// Registered maps of one material; nothing where one is not here.
std::optional<Exemplar> stackOf(const char* name,
                                const std::vector<std::pair<const char*, const char*>>& files) {
    std::vector<MapPicture> pictures;
    for (const auto& [map, file] : files) {
        auto exemplar = bench::photograph(file);
        if (!exemplar)
            return std::nullopt;
        pictures.push_back(
            {map, mapKindOfWord(map).value_or(MapKind::Data), std::move(exemplar->image), file});
    }
    auto stack = stackMaps(std::move(pictures));
    return stack ? std::optional(*makeExemplar(std::move(stack->image), name, stack->maps))
                 : std::nullopt;
}

/// How long a fit takes, when its first kernels of use can be seen, and how good those are.
void printSpeed(const Exemplar& exemplar, int side, std::optional<int> kernels) {
    using Clock = std::chrono::steady_clock;
    const GaussianModel model(exemplar);
    ComputeParams params;
    params.support = Support::rectangle({side, side});
    params.kernels = kernels;
    const auto start = Clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::optional<double> first;
    std::optional<Texton> seen;
    const auto computed = computeTexton(exemplar, model, params, [&](const ComputeProgress& now) {
        if (!first && now.iteration >= 12) {
            seen = now.texton();
            first = seconds();
        }
    });
    const double whole = seconds();
    if (!computed || !first)
        return;
    const auto early = covarianceError(exemplar, *seen);
    const auto end = covarianceError(exemplar, computed->texton);
    if (!early || !end)
        return;
    std::printf("| %s | %d | %d | %s | %.2f s | %.3f s | %.2f | %.2f |\n",
                exemplar.name.c_str(),
                exemplar.image.channels(),
                side,
                kernels ? std::to_string(*kernels).c_str()
                        : ("auto: " + std::to_string(computed->texton.kernelCount())).c_str(),
                whole,
                *first,
                early->error / early->floor,
                end->error / end->floor);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: txn_fidelity SHEETS ROWS\n", stderr);
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
    if (auto stack = stackOf("grass stack",
                             {{"color", "grass_stack/grass_basecolor.png"},
                              {"height", "grass_stack/grass_height.png"},
                              {"roughness", "grass_stack/grass_roughness.png"},
                              {"occlusion", "grass_stack/grass_ao.png"}}))
        all.push_back(std::move(*stack));
    if (auto stack = stackOf("gingham stack",
                             {{"color", "gingham_stack/gingham_basecolor.png"},
                              {"normal", "gingham_stack/gingham_normal.png"},
                              {"packed", "gingham_stack/gingham_ao_rough_metal.png"}}))
        all.push_back(std::move(*stack));
    std::printf(
        "| material | channels | support | halves differ by | papers | fit, Q = 1 | fit, Q = 2 "
        "| fit, Q = 4 | fit, auto |\n|---|---|---|---|---|---|---|---|---|\n");
    for (Exemplar& exemplar : all) {
        std::ranges::replace(exemplar.name, '/', '_');
        printRows(exemplar);
        writeSheet(exemplar, argv[1], argv[2]);
    }
    std::printf("\n<!-- speed -->\n\n| material | channels | support | kernels | whole | first "
                "kernels of use | their error, x the floor | at the end |\n"
                "|---|---|---|---|---|---|---|---|\n");
    for (const Exemplar& exemplar : all) {
        if (exemplar.name == "sand (generated)" || exemplar.name == "sand_640x480.png") {
            for (const int side : {64, 128}) {
                printSpeed(exemplar, side, 2);
                printSpeed(exemplar, side, {});
            }
        }
        if (!exemplar.maps.empty()) {
            printSpeed(exemplar, 64, 4);
            printSpeed(exemplar, 64, {});
        }
    }
    return 0;
}
