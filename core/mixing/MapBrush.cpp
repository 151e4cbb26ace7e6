// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mixing/MapBrush.h"

#include "core/base/Simd.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <tbb/parallel_for.h>
#include <utility>

namespace txn {
namespace {

/// Places of dabs are whole multiples of 1 / kGrid texels, so that what is computed from them is
/// exact: mirrored and wrapped dabs are equal to the bit.
constexpr double kGrid = 256.0;

double snapped(double v) {
    return std::round(v * kGrid) / kGrid;
}

/// NaN counts as 0.
double clampedUnit(double v) {
    return v > 0.0 ? std::min(v, 1.0) : 0.0;
}

double sides(const Image& map) {
    return 1.0 * map.width() + map.height();
}

/// Beyond 64 times the sides nobody sees a difference.
double clampedRadius(double radius, const Image& map) {
    return radius > 0.0 ? std::min(radius, 64.0 * sides(map)) : 0.0;
}

/// Soft dabs a sixteenth of a radius apart make ripples of 0.3 %; the scallops of hard ones stay
/// below a tenth of a texel.
double spacingFor(double radius) {
    return std::clamp(radius / 16.0, 0.25, std::sqrt(0.8 * std::max(radius, 1.0)));
}

/// Texels begin, begin + 1, ... end - 1 along one axis.
struct Span {
    std::int64_t begin = 0;
    std::int64_t end = 0;

    bool empty() const { return begin >= end; }
    Span joined(Span other) const {
        if (empty() || other.empty())
            return empty() ? other : *this;
        return {std::min(begin, other.begin), std::max(end, other.end)};
    }
};

/// Those whose middles are at most that far away.
Span reach(double at, double radius) {
    constexpr double kFar = 1e15;
    return {static_cast<std::int64_t>(std::ceil(std::clamp(at - radius - 0.5, -kFar, kFar))),
            static_cast<std::int64_t>(std::floor(std::clamp(at + radius + 0.5, -kFar, kFar)))};
}

/// The parts of a span on a map of `count` texels, each texel once; some may be empty.
std::array<Span, 2> onMap(Span span, int count, bool repeats) {
    if (span.empty())
        return {};
    if (!repeats)
        return {
            Span{std::max<std::int64_t>(span.begin, 0), std::min<std::int64_t>(span.end, count)}};
    const std::int64_t length = span.end - span.begin;
    if (length >= count)
        return {Span{0, count}};
    const std::int64_t begin = (span.begin % count + count) % count;
    return {Span{begin, std::min<std::int64_t>(begin + length, count)},
            Span{0, begin + length - count}};
}

/// From the middle of texel i to a place; of a map that repeats, to its nearest copy.
double distanceTo(std::int64_t i, double at, int count, bool repeats) {
    const double distance = std::abs(static_cast<double>(i) + 0.5 - at);
    return repeats ? std::min(distance, count - distance) : distance;
}

/// How a dab covers: `peak` as far as the edge begins, nothing from the radius on.
struct DabShape {
    float radius;
    float perEdge; ///< 1 / width of the edge
    float peak;
};

// By value: loops over std::max, of references, do not vectorise.
template <class T>
T larger(T a, T b) {
    return a > b ? a : b;
}
template <class T>
T smaller(T a, T b) {
    return a < b ? a : b;
}

/// One row of a dab. columns, row: squared distances along x and along y.
TXN_MULTIVERSION
void stampRow(DabShape dab,
              const float* columns,
              float row,
              float strength,
              const float* before,
              const float* goal,
              float* mask,
              float* map,
              std::size_t count) {
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        const float distance = std::sqrt(columns[i] + row);
        const float t = smaller(larger((dab.radius - distance) * dab.perEdge, 0.0F), 1.0F);
        const float covered = larger(mask[i], dab.peak * (t * t * (3.0F - 2.0F * t)));
        mask[i] = covered;
        // From the nearer end: exact at both, and where they are equal.
        const float share = strength * covered;
        const float way = goal[i] - before[i];
        map[i] = share < 0.5F ? before[i] + share * way : goal[i] - (1.0F - share) * way;
    }
}

/// Which texel stands for each of -half, 1 - half, ... count + half.
std::vector<int> texelsAround(int count, int half, bool repeats) {
    const int period = repeats ? count : 2 * count;
    std::vector<int> texels;
    texels.reserve(static_cast<std::size_t>(count + 2 * half + 1));
    for (int i = -half; i <= count + half; ++i) {
        const int at = (i % period + period) % period;
        texels.push_back(at < count ? at : 2 * count - 1 - at);
    }
    return texels;
}

// Means over 2 * half + 1 texels by running sums. In double these are exact for all values that a
// map of 16 bits can have, so that what is constant stays so, wherever the sum began.

void averageRows(const Image& in, Image& out, int half, bool repeats) {
    const auto texels = texelsAround(in.width(), half, repeats);
    const auto width = static_cast<std::size_t>(2 * half + 1);
    tbb::parallel_for(0, in.height(), [&](int y) {
        const float* from = in.row(0, y).data();
        float* to = out.row(0, y).data();
        double sum = 0.0;
        for (std::size_t k = 0; k < width; ++k)
            sum += static_cast<double>(from[texels[k]]);
        for (std::size_t x = 0; x + width < texels.size(); ++x) {
            to[x] = static_cast<float>(sum / static_cast<double>(width));
            sum +=
                static_cast<double>(from[texels[x + width]]) - static_cast<double>(from[texels[x]]);
        }
    });
}

TXN_MULTIVERSION
void slideSums(
    double* sums, const float* in, const float* gone, float* out, double width, int count) {
#pragma omp simd
    for (int i = 0; i < count; ++i) {
        // Tiny values that a large one swallowed are missing when it has gone.
        out[i] = static_cast<float>(larger(sums[i], 0.0) / width);
        sums[i] += static_cast<double>(in[i]) - static_cast<double>(gone[i]);
    }
}

void averageColumns(const Image& in, Image& out, int half, bool repeats) {
    constexpr int kColumns = 64; // at a time
    const auto texels = texelsAround(in.height(), half, repeats);
    const auto width = static_cast<std::size_t>(2 * half + 1);
    tbb::parallel_for(0, (in.width() + kColumns - 1) / kColumns, [&](int block) {
        const int first = block * kColumns;
        const int count = std::min(kColumns, in.width() - first);
        const auto row = [&](std::size_t k) { return in.row(0, texels[k]).data() + first; };
        std::array<double, kColumns> sums{};
        for (std::size_t k = 0; k < width; ++k) {
            for (int i = 0; i < count; ++i)
                sums[static_cast<std::size_t>(i)] += static_cast<double>(row(k)[i]);
        }
        for (std::size_t y = 0; y + width < texels.size(); ++y)
            slideSums(sums.data(),
                      row(y + width),
                      row(y),
                      out.row(0, static_cast<int>(y)).data() + first,
                      static_cast<double>(width),
                      count);
    });
}

/// Boxes of about a third of the radius, twice: a tent.
Image localMeans(Image map, double radius, bool repeats) {
    const int half = static_cast<int>(
        std::clamp(std::round(radius / 6.0), 1.0, 1.0 * std::max(map.width(), map.height())));
    Image other(map.size(), 1);
    for (int pass = 0; pass < 2; ++pass) {
        averageRows(map, other, half, repeats);
        averageColumns(other, map, half, repeats);
    }
    return map;
}

Image goalOf(const Brush& brush, const Image& before, bool repeats) {
    if (brush.mode == BrushMode::Smooth && brush.radius > 0.0)
        return localMeans(before, clampedRadius(brush.radius, before), repeats);
    const bool paints = brush.mode == BrushMode::Paint;
    return {Size{before.width(), 1},
            1,
            paints ? static_cast<float>(clampedUnit(static_cast<double>(brush.target))) : 0.0F};
}

double distanceOf(MapPoint a, MapPoint b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// Of a gradient: a millionth of a texel is none.
bool isUsable(double length) {
    return length > 1e-6 && std::isfinite(length);
}

/// Along a gradient: t below 0 and above 1 are its ends.
float gradientValue(double t, double from, double to, Ease ease) {
    t = smaller(larger(t, 0.0), 1.0);
    if (ease == Ease::Smooth)
        t *= t * (3.0 - 2.0 * t);
    return static_cast<float>(from + t * (to - from)); // in double: exact at both ends
}

/// along(x, y): t at the middle of a texel.
template <class Along>
void fillGradient(Image& map, float from, float to, Ease ease, const Along& along) {
    if (std::isnan(from) || std::isnan(to))
        return;
    const double first = clampedUnit(static_cast<double>(from));
    const double last = clampedUnit(static_cast<double>(to));
    tbb::parallel_for(0, map.height(), [&](int y) {
        float* row = map.row(0, y).data();
        for (int x = 0; x < map.width(); ++x)
            row[x] = gradientValue(along(x + 0.5, y + 0.5), first, last, ease);
    });
}

} // namespace

/// Touched texels; of a map that repeats, wherever its copies lie.
struct BrushStroke::Box {
    Span x;
    Span y;
};

BrushStroke::BrushStroke(Image before, const Brush& brush, Symmetry symmetry, bool repeats)
    : m_before(std::move(before)), m_goal(goalOf(brush, m_before, repeats)),
      m_mask(m_before.size(), 1), m_radius(clampedRadius(brush.radius, m_before)),
      m_hardness(clampedUnit(brush.hardness)),
      m_strength(static_cast<float>(clampedUnit(brush.strength))), m_symmetry(symmetry),
      m_repeats(repeats), m_spacing(spacingFor(m_radius)),
      m_columns(static_cast<std::size_t>(m_before.width())) {
    assert(m_before.channels() == 1);
}

std::vector<Rect> BrushStroke::moveTo(double x, double y, double pressure, Image& map) {
    assert(map.size() == m_before.size() && map.channels() == 1);
    if (!std::isfinite(x) || !std::isfinite(y) || std::isnan(pressure) || m_radius == 0.0)
        return {};
    const Point to{x, y, clampedUnit(pressure)};
    // A pen that presses harder where it stands moves, too.
    const auto way = [this](const Point& a, const Point& b) {
        return std::hypot(b.x - a.x, b.y - a.y, m_radius * (b.pressure - a.pressure));
    };
    if (!m_last || !(way(*m_last, to) <= 16.0 * sides(map) + m_radius)) {
        m_last = to;
        m_toNext = 0.0;
    }
    const Point from = *m_last;
    const double length = way(from, to);
    std::vector<Box> touched(4);
    constexpr double kRounding = 1e-6; // of many short moves
    for (; m_toNext <= length + kRounding; m_toNext += m_spacing) {
        const double t = length > 0.0 ? std::min(m_toNext / length, 1.0) : 0.0;
        stampCopies({std::lerp(from.x, to.x, t),
                     std::lerp(from.y, to.y, t),
                     std::lerp(from.pressure, to.pressure, t)},
                    map,
                    touched);
    }
    m_toNext -= length;
    m_last = to;

    std::vector<Rect> dirty;
    for (const Box& box : touched) {
        for (const Span rows : onMap(box.y, map.height(), m_repeats)) {
            for (const Span columns : onMap(box.x, map.width(), m_repeats)) {
                if (!rows.empty() && !columns.empty())
                    dirty.push_back({columns.begin,
                                     rows.begin,
                                     {static_cast<int>(columns.end - columns.begin),
                                      static_cast<int>(rows.end - rows.begin)}});
            }
        }
    }
    return dirty;
}

void BrushStroke::stampCopies(const Point& at, Image& map, std::vector<Box>& touched) {
    const Point place{snapped(at.x), snapped(at.y), at.pressure};
    for (std::size_t copy = 0; copy < touched.size(); ++copy) {
        const bool mirrorX = copy % 2 == 1;
        const bool mirrorY = copy / 2 == 1;
        if ((mirrorX && !m_symmetry.acrossVertical) || (mirrorY && !m_symmetry.acrossHorizontal))
            continue;
        const Box box = stamp({mirrorX ? map.width() - place.x : place.x,
                               mirrorY ? map.height() - place.y : place.y,
                               place.pressure},
                              map);
        touched[copy] = {touched[copy].x.joined(box.x), touched[copy].y.joined(box.y)};
    }
}

BrushStroke::Box BrushStroke::stamp(const Point& at, Image& map) {
    const double radius = std::max(1.0, m_radius * (0.5 + 0.5 * at.pressure));
    const Box box{reach(at.x, radius), reach(at.y, radius)};
    const auto columns = onMap(box.x, map.width(), m_repeats);
    const auto rows = onMap(box.y, map.height(), m_repeats);
    if (at.pressure == 0.0 || columns[0].empty() || rows[0].empty())
        return {};
    const double x = m_repeats ? at.x - std::floor(at.x / map.width()) * map.width() : at.x;
    const double y = m_repeats ? at.y - std::floor(at.y / map.height()) * map.height() : at.y;
    const DabShape shape{static_cast<float>(radius),
                         static_cast<float>(1.0 / std::max(1.0, radius * (1.0 - m_hardness))),
                         static_cast<float>(at.pressure)};
    for (const Span part : columns) {
        for (auto i = part.begin; i < part.end; ++i) {
            const double distance = distanceTo(i, x, map.width(), m_repeats);
            m_columns[static_cast<std::size_t>(i)] = static_cast<float>(distance * distance);
        }
    }
    for (const Span part : rows) {
        for (auto j = part.begin; j < part.end; ++j) {
            const double distance = distanceTo(j, y, map.height(), m_repeats);
            const int row = static_cast<int>(j);
            for (const Span run : columns) {
                if (run.empty())
                    continue;
                const auto first = static_cast<std::size_t>(run.begin);
                stampRow(shape,
                         m_columns.data() + first,
                         static_cast<float>(distance * distance),
                         m_strength,
                         m_before.row(0, row).data() + first,
                         m_goal.row(0, m_goal.height() > 1 ? row : 0).data() + first,
                         m_mask.row(0, row).data() + first,
                         map.row(0, row).data() + first,
                         static_cast<std::size_t>(run.end - run.begin));
            }
        }
    }
    return box;
}

void fillMap(Image& map, float rho) {
    if (!std::isnan(rho))
        std::ranges::fill(map.samples(), std::clamp(rho, 0.0F, 1.0F));
}

void linearGradient(Image& map, MapPoint from, MapPoint to, float rhoFrom, float rhoTo, Ease ease) {
    const double length = distanceOf(from, to);
    if (!isUsable(length))
        return;
    // Divided twice: the square of a length may be beyond all numbers.
    const double stepX = (to.x - from.x) / length / length;
    const double stepY = (to.y - from.y) / length / length;
    fillGradient(map, rhoFrom, rhoTo, ease, [&](double x, double y) {
        return (x - from.x) * stepX + (y - from.y) * stepY;
    });
}

void radialGradient(
    Image& map, MapPoint centre, MapPoint onCircle, float rhoInside, float rhoOutside, Ease ease) {
    const double radius = distanceOf(centre, onCircle);
    if (!isUsable(radius))
        return;
    fillGradient(map, rhoInside, rhoOutside, ease, [&](double x, double y) {
        return std::sqrt((x - centre.x) * (x - centre.x) + (y - centre.y) * (y - centre.y)) /
               radius;
    });
}

Image stripMap(Size size, int strips, double degreesClockwise, Ease ease) {
    const double count = std::max(strips, 1);
    Image map = gradientMap(size, std::isfinite(degreesClockwise) ? degreesClockwise : 0.0, ease);
    for (float& rho : map.samples()) {
        const double strip = std::min(std::floor(static_cast<double>(rho) * count), count - 1.0);
        rho = count > 1.0 ? static_cast<float>(strip / (count - 1.0)) : 0.0F;
    }
    return map;
}

} // namespace txn
