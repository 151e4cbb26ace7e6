// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Samples.h"

#include "core/samples/Recipes.h"

#include <algorithm>
#include <array>
#include <string>

namespace txn {
namespace {

constexpr int kSmallestSide = 16;
constexpr int kLargestSide = 16384;

constexpr std::array<SampleInfo, 7> kCatalog{{
    {"wood", "oak board with straight grain and fine dark pores"},
    {"stone", "speckled granite of feldspar, quartz and mica"},
    {"sand", "dry beach sand, fine warm grains"},
    {"rust", "weathered steel, orange to dark brown"},
    {"metal", "brushed steel with a soft sheen"},
    {"cloth", "plain-woven linen with uneven yarns"},
    {"leather", "pebbled brown leather"},
}};

using Recipe = Image (*)(Size, Seed);

/// In the order of the catalogue.
constexpr std::array<Recipe, kCatalog.size()> kRecipes{
    makeWood, makeStone, makeSand, makeRust, makeMetal, makeCloth, makeLeather};

std::string catalogNames() {
    std::string names;
    for (const SampleInfo& sample : kCatalog)
        names.append(names.empty() ? "" : ", ").append(sample.name);
    return names;
}

bool isAllowed(int side) {
    return side >= kSmallestSide && side <= kLargestSide;
}

} // namespace

std::span<const SampleInfo> sampleCatalog() {
    return kCatalog;
}

Result<Image> makeSample(std::string_view name, Size size, Seed seed) {
    const auto found = std::find_if(kCatalog.begin(), kCatalog.end(), [name](const auto& sample) {
        return sample.name == name;
    });
    if (found == kCatalog.end())
        return Error{ErrorCode::InvalidArgument,
                     "no sample is called '" + std::string(name) + "'; choose one of " +
                         catalogNames()};
    if (!isAllowed(size.width) || !isAllowed(size.height))
        return Error{ErrorCode::InvalidArgument,
                     "a sample of " + std::to_string(size.width) + " x " +
                         std::to_string(size.height) +
                         " cannot be made; choose a width and height from " +
                         std::to_string(kSmallestSide) + " to " + std::to_string(kLargestSide)};
    return kRecipes[static_cast<std::size_t>(found - kCatalog.begin())](size, seed);
}

} // namespace txn
