// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"
#include "core/texton/Texton.h"

#include <vector>

namespace txn {

/// C x C covariance of a texture at every lag (dx, dy), |dx|, |dy| <= maxLag: at(i, j, dx, dy) is
/// the covariance of channel i at x + (dx, dy) and channel j at x. Double precision.
class Autocovariance {
  public:
    Autocovariance(int channels, int maxLag);

    int channels() const { return m_channels; }
    int maxLag() const { return m_maxLag; }
    double& at(int i, int j, int dx, int dy) { return m_values[index(i, j, dx, dy)]; }
    double at(int i, int j, int dx, int dy) const { return m_values[index(i, j, dx, dy)]; }

    /// Of the channels times these factors, one each.
    [[nodiscard]] Autocovariance weighted(const std::vector<double>& weights) const;

    /// Root of the sum of squares over channels and lags up to the given one in size.
    [[nodiscard]] double norm(int lag) const;
    /// Norm of the difference; both of equal channels, and lag within both.
    [[nodiscard]] double distance(const Autocovariance& other, int lag) const;

  private:
    std::size_t index(int i, int j, int dx, int dy) const;

    int m_channels;
    int m_maxLag;
    std::vector<double> m_values;
};

/// Of a picture, its own mean removed: the mean of the products over all pairs of pixels inside
/// (unbiased up to the mean, not wrapped). maxLag is below both sides. Thread-safe.
[[nodiscard]] Autocovariance autocovariance(const Image& image, int maxLag);

/// Of the noise of a texton, exactly: sum over kernels of (alpha * alpha~ * b)(lag); the same for
/// all processes and any MNI. Thread-safe.
[[nodiscard]] Autocovariance autocovariance(const Texton& texton, int maxLag);

} // namespace txn
