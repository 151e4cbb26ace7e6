// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/Variation.h"

#include <algorithm>
#include <cmath>

namespace txn {

bool varies(const GaussianModel& model) {
    double mean = 0.0;
    for (const double m : model.mean())
        mean = std::max(mean, std::abs(m));
    return std::sqrt(model.covariance().trace() / model.channels()) > 1e-6 * mean;
}

} // namespace txn
