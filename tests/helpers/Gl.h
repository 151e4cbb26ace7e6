// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/HeadlessContext.h"
#include "gl/NoiseRenderer.h"
#include "tests/helpers/Numbers.h"

#include <QtTest>

#include <memory>
#include <optional>

namespace txn::test {

/// Makes a context in an std::optional<HeadlessContext>, for initTestCase. Where there is no OpenGL
/// everything is skipped, unless the environment has TXN_REQUIRE_GL=1: then it fails.
#define TXN_NEEDS_GL(context)                                                                      \
    do {                                                                                           \
        auto made_ = txn::HeadlessContext::create();                                               \
        if (!made_ && qEnvironmentVariableIntValue("TXN_REQUIRE_GL") == 1)                         \
            QFAIL(made_.error().message.c_str());                                                  \
        if (!made_)                                                                                \
            QSKIP(made_.error().message.c_str());                                                  \
        (context).emplace(std::move(*made_));                                                      \
        qInfo("%s", (context)->gl().renderer().c_str());                                           \
    } while (false)

inline std::shared_ptr<const Texton> shared(Texton texton) {
    return std::make_shared<const Texton>(std::move(texton));
}

/// The picture of a view, all four channels unless told otherwise.
inline Result<Image> drawn(const GlContext& context,
                           NoiseRenderer& renderer,
                           const View& view,
                           const NoiseStyle& style,
                           Size size,
                           int channels = 4) {
    const auto target = OffscreenTarget::create(context, size);
    if (!target)
        return target.error();
    if (auto ok = renderer.draw(context, view, style, *target); !ok)
        return ok.error();
    return target->read(channels, Transfer::Encoded);
}

/// The style in which a pixel is a point of the noise.
inline NoiseStyle pointStyle(NoiseProcess process = NoiseProcess::Stratified,
                             double meanImpacts = 12.0,
                             std::uint32_t seed = 5) {
    NoiseStyle style;
    style.noise.process = process;
    style.noise.meanImpacts = meanImpacts;
    style.noise.seed = {seed};
    style.filter = Filter::None;
    return style;
}

/// Which channel of a texton a channel of the picture shows; nothing: none of them.
inline std::optional<int> shownChannel(int channels, int pictureChannel) {
    if (channels == 1 && pictureChannel < 3)
        return 0;
    if (pictureChannel < channels && (pictureChannel < 3 || channels == 4))
        return pictureChannel;
    return {};
}

/// Root mean square of the difference; NaN where the lengths differ or anything is not a number.
template <class A, class B>
double rmsDifference(const A& a, const B& b) {
    if (std::size(a) != std::size(b))
        return std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0;
    for (std::size_t i = 0; i < std::size(a); ++i) {
        const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(std::size(a)));
}

/// The share of samples that differ by more than the tolerance, or are not numbers.
template <class A, class B>
double shareBeyond(const A& a, const B& b, double tolerance) {
    if (std::size(a) != std::size(b) || std::size(a) == 0)
        return std::numeric_limits<double>::quiet_NaN();
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::size(a); ++i) {
        if (!(std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) <= tolerance))
            ++count;
    }
    return static_cast<double>(count) / static_cast<double>(std::size(a));
}

} // namespace txn::test
