// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <vector>

namespace txn::bench {

/// The alternating projections as a textbook has them, to measure the library against: double
/// precision, full complex FFTs of the whole domain, one thread, no momentum.
/// spot: t_u, H x W x C. Returns the coefficients, w x h x C in the order of Image::samples().
std::vector<double> textbookTexton(const Image& spot,
                                   const Image& initialNoise,
                                   Size support,
                                   int interpolationOrder,
                                   int iterations);

} // namespace txn::bench
