// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/ColorCorrection.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace txn {
namespace {

/// Eigenvalues below this share of the largest are rounding errors of single precision (1e-14).
/// Material maps may differ in contrast by 1e5, in variance by 1e10, and are all real.
constexpr double kRankTolerance = 1e-13;

/// f of the symmetric matrix, with f = 0 on its numerical null space.
template <class Function>
Eigen::MatrixXd spectralFunction(const Eigen::MatrixXd& matrix, Function f) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const double threshold = kRankTolerance * solver.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd mapped =
        solver.eigenvalues().unaryExpr([&](double v) { return v > threshold ? f(v) : 0.0; });
    return solver.eigenvectors() * mapped.asDiagonal() * solver.eigenvectors().transpose();
}

} // namespace

Texton colorCorrected(const Texton& texton, const Eigen::MatrixXd& target) {
    const int channels = texton.channels();
    const auto covariance = noiseCovariance(texton);
    const Eigen::MatrixXd actual =
        Eigen::Map<const Eigen::MatrixXd>(covariance.data(), channels, channels);
    const Eigen::MatrixXd matrix =
        spectralFunction(target, [](double v) { return std::sqrt(v); }) *
        spectralFunction(actual, [](double v) { return 1.0 / std::sqrt(v); });

    Texton result = texton;
    for (std::size_t q = 0; q < texton.kernels.size(); ++q) {
        const Image& from = texton.kernels[q];
        Image& to = result.kernels[q];
        for (int i = 0; i < channels; ++i) {
            const auto out = to.plane(i);
            for (std::size_t k = 0; k < out.size(); ++k) {
                double sum = 0.0;
                for (int j = 0; j < channels; ++j)
                    sum += matrix(i, j) * from.plane(j)[k];
                out[k] = static_cast<float>(sum);
            }
        }
    }
    return result;
}

} // namespace txn
