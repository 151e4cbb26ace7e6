// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/Barycentre.h"

#include "core/gaussian/GaussianSampler.h"
#include "core/gaussian/Variation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

/// t_u^* t_v at one frequency, over all channels.
std::complex<double>
scalarProduct(const GaussianModel& u, const GaussianModel& v, int block, std::size_t k) {
    double real = 0.0;
    double imaginary = 0.0;
    for (int c = 0; c < u.channels(); ++c) {
        const std::complex<double> a(u.spot(c).block(block)[k]);
        const std::complex<double> b(v.spot(c).block(block)[k]);
        real += a.real() * b.real() + a.imag() * b.imag();
        imaginary += a.real() * b.imag() - a.imag() * b.real();
    }
    return {real, imaginary};
}

/// The same texture as u, its phases turned towards v's.
GaussianModel turnedTowards(const GaussianModel& u, const GaussianModel& v) {
    std::vector<HalfSpectrum> spot(static_cast<std::size_t>(u.channels()));
    for (HalfSpectrum& plane : spot)
        plane = HalfSpectrum(u.domain());
    tbb::parallel_for(0, v.spot(0).blocks(), [&](int b) {
        for (std::size_t k = 0; k < v.spot(0).block(b).size(); ++k) {
            const auto product = scalarProduct(u, v, b, k);
            const double size = std::sqrt(std::norm(product));
            const Complex phase = size > 0.0 ? Complex(product / size) : Complex(1.0F);
            for (int c = 0; c < u.channels(); ++c)
                spot[static_cast<std::size_t>(c)].block(b)[k] = u.spot(c).block(b)[k] * phase;
        }
    });
    return {std::move(spot), u.mean(), u.transfer()};
}

Result<void> checkVaries(const GaussianModel& model, const char* which) {
    if (varies(model))
        return {};
    return Error{ErrorCode::Degenerate,
                 std::string("exemplar ") + which +
                     " is one flat colour: there is no texture to mix"};
}

/// Slopes inside a stack are the same whichever way the file's green pointed.
bool sameMap(const MaterialMap& a, const MaterialMap& b) {
    return a.name == b.name && (a.kind == b.kind || (isNormal(a.kind) && isNormal(b.kind)));
}

std::string channelsText(int count) {
    return std::to_string(count) + (count == 1 ? " channel" : " channels");
}

Result<void> checkAlike(int channelsA, int channelsB, Transfer a, Transfer b) {
    if (channelsA != channelsB)
        return Error{ErrorCode::SizeMismatch,
                     "exemplar A has " + channelsText(channelsA) + " and exemplar B " +
                         channelsText(channelsB) + "; choose pictures of one kind"};
    if (a != b)
        return Error{
            ErrorCode::SizeMismatch,
            "one exemplar is linear light and the other is not; use linear light for both, "
            "or pictures of one kind"};
    return {};
}

} // namespace

double transportDistance(const GaussianModel& u, const GaussianModel& v) {
    assert(u.domain() == v.domain() && u.channels() == v.channels());
    const int blocks = u.spot(0).blocks();
    // One partial sum per block, added up in order: the same bits for any number of threads.
    std::vector<double> partial(static_cast<std::size_t>(blocks), 0.0);
    tbb::parallel_for(0, blocks, [&](int b) {
        for (std::size_t k = 0; k < u.spot(0).block(b).size(); ++k) {
            double energy = -2.0 * std::sqrt(std::norm(scalarProduct(u, v, b, k)));
            for (int c = 0; c < u.channels(); ++c)
                energy += std::norm(std::complex<double>(u.spot(c).block(b)[k])) +
                          std::norm(std::complex<double>(v.spot(c).block(b)[k]));
            const int column = b * FftPlan::kLanes + static_cast<int>(k % FftPlan::kLanes);
            partial[static_cast<std::size_t>(b)] += u.spot(0).multiplicity(column) * energy;
        }
    });
    double square = std::accumulate(partial.begin(), partial.end(), 0.0) /
                    static_cast<double>(u.domain().area());
    for (std::size_t c = 0; c < u.mean().size(); ++c)
        square += (u.mean()[c] - v.mean()[c]) * (u.mean()[c] - v.mean()[c]);
    return std::sqrt(std::max(square, 0.0));
}

Result<BarycentrePath>
BarycentrePath::create(const Exemplar& a, const Exemplar& b, bool periodicA, bool periodicB) {
    // Before any work on pictures that cannot be mixed.
    if (const auto ok = checkAlike(a.image.channels(),
                                   b.image.channels(),
                                   a.image.transfer(),
                                   b.image.transfer());
        !ok)
        return ok.error();
    if (!std::ranges::equal(a.maps, b.maps, sameMap))
        return Error{ErrorCode::SizeMismatch,
                     "the exemplars are stacks of different maps; give both the same maps, in the "
                     "same order"};
    const Size domain{std::max(a.image.width(), b.image.width()),
                      std::max(a.image.height(), b.image.height())};
    const auto model = [&](const Exemplar& exemplar, bool periodic) -> Result<GaussianModel> {
        if (exemplar.image.size() == domain)
            return GaussianModel(exemplar, periodic);
        return enlarged(exemplar, domain, periodic);
    };
    auto modelA = model(a, periodicA);
    if (!modelA)
        return modelA.error();
    auto modelB = model(b, periodicB);
    if (!modelB)
        return modelB.error();
    return create(*modelA, std::move(*modelB));
}

Result<BarycentrePath> BarycentrePath::create(const GaussianModel& a, GaussianModel b) {
    if (const auto ok = checkAlike(a.channels(), b.channels(), a.transfer(), b.transfer()); !ok)
        return ok.error();
    if (a.domain() != b.domain())
        return Error{ErrorCode::SizeMismatch, "the models to mix must have one domain"};
    if (const auto ok = checkVaries(a, "A"); !ok)
        return ok.error();
    if (const auto ok = checkVaries(b, "B"); !ok)
        return ok.error();
    GaussianModel turned = turnedTowards(a, b);
    return BarycentrePath(std::move(turned), std::move(b));
}

BarycentrePath::BarycentrePath(GaussianModel a, GaussianModel b)
    : m_a(std::move(a)), m_b(std::move(b)), m_distance(transportDistance(m_a, m_b)) {}

GaussianModel BarycentrePath::at(double rho) const {
    assert(rho >= 0.0 && rho <= 1.0);
    const auto near = static_cast<float>(1.0 - rho);
    const auto far = static_cast<float>(rho);
    std::vector<HalfSpectrum> spot(static_cast<std::size_t>(channels()));
    std::vector<double> mean;
    for (std::size_t c = 0; c < spot.size(); ++c) {
        spot[c] = HalfSpectrum(domain());
        mean.push_back((1.0 - rho) * m_a.mean()[c] + rho * m_b.mean()[c]);
    }
    tbb::parallel_for(0, m_b.spot(0).blocks(), [&](int b) {
        for (int c = 0; c < channels(); ++c) {
            const auto from = m_a.spot(c).block(b);
            const auto to = m_b.spot(c).block(b);
            const auto out = spot[static_cast<std::size_t>(c)].block(b);
            for (std::size_t k = 0; k < out.size(); ++k)
                out[k] = near * from[k] + far * to[k];
        }
    });
    return {std::move(spot), std::move(mean), m_b.transfer()};
}

} // namespace txn
