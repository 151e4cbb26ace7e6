// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/GaussianModel.h"

#include "core/spectral/PeriodicComponent.h"

#include <cmath>
#include <numeric>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

double meanOf(std::span<const float> plane) {
    return std::accumulate(plane.begin(), plane.end(), 0.0) / static_cast<double>(plane.size());
}

void scaleAndDropMean(HalfSpectrum& spectrum, float scale) {
    tbb::parallel_for(0, spectrum.blocks(), [&](int b) {
        for (Complex& v : spectrum.block(b))
            v *= scale;
    });
    spectrum.at(0, 0) = Complex{};
}

} // namespace

GaussianModel::GaussianModel(const Exemplar& exemplar, bool periodic)
    : m_periodicComponent(periodic), m_domain(exemplar.image.size()),
      m_transfer(exemplar.image.transfer()) {
    const RealFft2d fft(m_domain);
    const auto scale = static_cast<float>(1.0 / std::sqrt(static_cast<double>(m_domain.area())));
    for (int c = 0; c < exemplar.image.channels(); ++c) {
        const auto plane = exemplar.image.plane(c);
        m_mean.push_back(meanOf(plane));
        m_spot.push_back(fft.forward(plane, static_cast<float>(-m_mean.back())));
        if (periodic)
            removeSmoothComponent(m_spot.back(), plane);
        scaleAndDropMean(m_spot.back(), scale);
    }
    computeCovariance();
}

GaussianModel::GaussianModel(const Image& spot, std::vector<double> mean)
    : m_domain(spot.size()), m_transfer(spot.transfer()), m_mean(std::move(mean)) {
    const RealFft2d fft(m_domain);
    for (int c = 0; c < spot.channels(); ++c) {
        m_spot.push_back(fft.forward(spot.plane(c)));
        scaleAndDropMean(m_spot.back(), 1.0F);
    }
    computeCovariance();
}

GaussianModel::GaussianModel(std::vector<HalfSpectrum> spot,
                             std::vector<double> mean,
                             Transfer transfer)
    : m_domain(spot.front().imageSize()), m_transfer(transfer), m_mean(std::move(mean)),
      m_spot(std::move(spot)) {
    computeCovariance();
}

void GaussianModel::computeCovariance() {
    const int count = channels();
    const int blocks = HalfSpectrum::blocksFor(m_domain.width);
    // One partial sum per block, added up in order: the same bits for any number of threads.
    std::vector<Eigen::MatrixXd> partial(static_cast<std::size_t>(blocks),
                                         Eigen::MatrixXd::Zero(count, count));
    tbb::parallel_for(0, blocks, [&](int b) {
        auto& sum = partial[static_cast<std::size_t>(b)];
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j <= i; ++j) {
                const auto left = spot(i).block(b);
                const auto right = spot(j).block(b);
                double lanes[FftPlan::kLanes] = {};
                for (std::size_t k = 0; k < left.size(); ++k) {
                    const double product = static_cast<double>(left[k].real()) * right[k].real() +
                                           static_cast<double>(left[k].imag()) * right[k].imag();
                    lanes[k % FftPlan::kLanes] += product;
                }
                for (int lane = 0; lane < FftPlan::kLanes; ++lane)
                    sum(i, j) += lanes[lane] * spot(i).multiplicity(b * FftPlan::kLanes + lane);
            }
        }
    });
    m_covariance = Eigen::MatrixXd::Zero(count, count);
    for (const auto& sum : partial)
        m_covariance += sum;
    m_covariance /= static_cast<double>(m_domain.area());
    m_covariance = m_covariance.selfadjointView<Eigen::Lower>();
}

} // namespace txn
