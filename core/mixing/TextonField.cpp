// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mixing/TextonField.h"

#include "core/spectral/BSpline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace txn {
namespace {

/// The B-spline spans four cells.
int cellsAlong(double length, int footprint) {
    return static_cast<int>(
        std::clamp(std::round(length / (0.25 * footprint)), 1.0, 1.0 * MixingMap::kMaxSide));
}

/// Means of `from` equal texels over `to` equal cells of the same length.
void averageCells(const float* in, int from, std::ptrdiff_t step, float* out, int to) {
    for (int cell = 0; cell < to; ++cell) {
        const double begin = static_cast<double>(cell) * from / to;
        const double end = static_cast<double>(cell + 1) * from / to;
        const auto first = static_cast<int>(begin);
        const int last = std::min(from - 1, static_cast<int>(std::ceil(end)) - 1);
        // Differences from one of the values: exact where all are equal.
        const auto base = static_cast<double>(in[first * step]);
        double sum = 0.0;
        for (int i = first; i <= last; ++i)
            sum += (std::min(end, i + 1.0) - std::max(begin, 1.0 * i)) *
                   (static_cast<double>(in[i * step]) - base);
        out[cell * step] = static_cast<float>(base + sum / (end - begin));
    }
}

} // namespace

std::vector<float> gridMeans(std::span<const float> values, Size from, Size to) {
    assert(values.size() == from.area());
    // Along x, then along y.
    const auto width = static_cast<std::size_t>(to.width);
    std::vector<float> rows(static_cast<std::size_t>(from.height) * width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(from.height); ++y)
        averageCells(values.data() + y * static_cast<std::size_t>(from.width),
                     from.width,
                     1,
                     rows.data() + y * width,
                     to.width);
    std::vector<float> means(to.area());
    for (int x = 0; x < to.width; ++x)
        averageCells(rows.data() + x, from.height, to.width, means.data() + x, to.height);
    return means;
}

/// Four neighbouring cells and their weights.
struct TextonField::Taps {
    int cell[4];
    float weight[4];
};

TextonField::TextonField(const MixingMap& map, int textons, Size footprint)
    : m_textonCount(textons),
      m_size(map.rho.size()), m_cells{cellsAlong(map.placement.width, footprint.width),
                                      cellsAlong(map.placement.height, footprint.height)},
      m_placement(map.placement), m_boundary(map.boundary), m_positions(m_size.area()) {
    assert(textons >= 1 && textons <= kMaxTextons && checkMixingMap(map));
    const double scale = static_cast<double>(textons - 1) * kSteps;
    std::ranges::transform(map.rho.samples(), m_positions.begin(), [scale](float rho) {
        return static_cast<std::uint16_t>(std::lround(scale * static_cast<double>(rho)));
    });
    m_constant =
        m_positions.front() % kSteps == 0 && std::ranges::all_of(m_positions, [&](auto position) {
            return position == m_positions.front();
        });

    std::vector<float> along(m_positions.size());
    std::ranges::transform(m_positions, along.begin(), [](std::uint16_t position) {
        return static_cast<float>(position) / static_cast<float>(kSteps);
    });
    m_coefficients = gridMeans(along, m_size, m_cells);
}

TextonField::Taps TextonField::taps(double at, double start, double length, int count) const {
    // Cell i is centred on (i + 1/2) cells.
    const auto weights = bsplineWeights(3, (at - start) / length * count - 0.5);
    Taps result{};
    for (int i = 0; i < 4; ++i) {
        result.cell[i] = wrapped(static_cast<double>(weights.first + i), count);
        result.weight[i] = weights.weight[i];
    }
    return result;
}

void TextonField::meanPositions(std::span<const double> xs,
                                std::span<const double> ys,
                                std::span<float> out) const {
    assert(out.size() == xs.size() * ys.size());
    std::vector<Taps> horizontal;
    std::vector<int> used;
    horizontal.reserve(xs.size());
    for (const double x : xs) {
        horizontal.push_back(taps(x, m_placement.left, m_placement.width, m_cells.width));
        for (const int cell : horizontal.back().cell) {
            if (used.empty() || std::ranges::find(used, cell) == used.end())
                used.push_back(cell);
        }
    }
    // Differences from one of the values are added up: exact where all are equal.
    std::vector<float> columns(static_cast<std::size_t>(m_cells.width));
    float* result = out.data();
    for (const double y : ys) {
        const Taps vertical = taps(y, m_placement.top, m_placement.height, m_cells.height);
        for (const int cell : used) {
            const auto value = [&](int i) {
                return m_coefficients[static_cast<std::size_t>(vertical.cell[i]) *
                                          static_cast<std::size_t>(m_cells.width) +
                                      static_cast<std::size_t>(cell)];
            };
            float& column = columns[static_cast<std::size_t>(cell)];
            column = value(0);
            for (int i = 1; i < 4; ++i)
                column += vertical.weight[i] * (value(i) - value(0));
        }
        for (const Taps& taps : horizontal) {
            const float first = columns[static_cast<std::size_t>(taps.cell[0])];
            *result = first;
            for (int i = 1; i < 4; ++i)
                *result +=
                    taps.weight[i] * (columns[static_cast<std::size_t>(taps.cell[i])] - first);
            ++result;
        }
    }
}

} // namespace txn
