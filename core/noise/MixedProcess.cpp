// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/MixedProcess.h"

#include "core/noise/Normalization.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace txn {
namespace {

std::string shortLength(double length) {
    return std::to_string(std::llround(length));
}

bool isMultiple(double length, double part) {
    const double times = length / part;
    return std::round(times) >= 1.0 && std::abs(times - std::round(times)) < 1e-9 * times;
}

} // namespace

Result<void> checkMixing(std::size_t textons,
                         const MapPlacement& placement,
                         MapBoundary boundary,
                         const NoiseParams& params) {
    if (textons == 1)
        return {};
    if (params.process == NoiseProcess::Poisson)
        return Error{ErrorCode::InvalidArgument,
                     "a mixture needs impacts of both signs; choose the stratified or the signed "
                     "process"};
    if (params.period &&
        (boundary != MapBoundary::Repeat || !isMultiple(params.period->width, placement.width) ||
         !isMultiple(params.period->height, placement.height)))
        return Error{ErrorCode::InvalidArgument,
                     "a mixture repeats only with its map; let the map repeat, and the tile be a "
                     "multiple of its " +
                         shortLength(placement.width) + " x " + shortLength(placement.height) +
                         " pixels"};
    return {};
}

Result<void> checkMixedNoise(const Mixture& mixture, const NoiseParams& params) {
    if (const auto ok = checkNoiseParams(params); !ok)
        return ok.error();
    if (const auto ok = checkMixture(mixture); !ok)
        return ok.error();
    return checkMixing(mixture.textons.size(), mixture.map.placement, mixture.map.boundary, params);
}

std::vector<double> mixedMean(const TextonField& field,
                              std::span<const std::vector<double>> offsets,
                              double x,
                              double y) {
    float position = 0.0F;
    field.meanPositions(std::span(&x, 1), std::span(&y, 1), std::span(&position, 1));
    const auto left = static_cast<std::size_t>(position);
    const std::size_t right = std::min(left + 1, offsets.size() - 1);
    const double share = static_cast<double>(position) - static_cast<double>(left);
    std::vector<double> means = offsets[left];
    for (std::size_t c = 0; c < means.size(); ++c)
        means[c] += share * (offsets[right][c] - offsets[left][c]);
    return means;
}

MixedProcess::MixedProcess(Mixture mixture, const NoiseParams& params)
    : m_textons(std::move(mixture.textons)),
      m_field(mixture.map, static_cast<int>(m_textons.size()), first().footprint()),
      m_impulses(params, first().footprint(), first().kernelCount()),
      m_gain(normalization(first(), m_impulses).gain), m_middleX(0.5 * first().footprint().width),
      m_middleY(0.5 * first().footprint().height) {
    for (const Texton& texton : m_textons)
        m_offsets.push_back(normalization(texton, m_impulses).offset);
}

void MixedProcess::addMean(std::span<const double> xs,
                           std::span<const double> ys,
                           Image& picture) const {
    if (m_field.isConstant()) {
        const auto& offsets = m_offsets[static_cast<std::size_t>(m_field.textonAt(0.0, 0.0, 0))];
        for (int c = 0; c < channels(); ++c) {
            const auto offset = static_cast<float>(offsets[static_cast<std::size_t>(c)]);
            for (float& v : picture.plane(c))
                v += offset;
        }
        return;
    }
    std::vector<float> positions(xs.size() * ys.size());
    m_field.meanPositions(xs, ys, positions);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c) {
        std::vector<float> offsets;
        for (const auto& one : m_offsets)
            offsets.push_back(static_cast<float>(one[c]));
        offsets.push_back(offsets.back()); // right of the last one: taken with weight 0
        const auto plane = picture.plane(static_cast<int>(c));
        for (std::size_t i = 0; i < plane.size(); ++i) {
            const auto left = static_cast<std::size_t>(positions[i]);
            const float share = positions[i] - static_cast<float>(left);
            plane[i] += offsets[left] + share * (offsets[left + 1] - offsets[left]);
        }
    }
}

} // namespace txn
