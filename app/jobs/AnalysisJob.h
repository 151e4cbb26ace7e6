// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/jobs/JobRunner.h"
#include "app/jobs/Results.h"
#include "core/noise/NoiseParams.h"

namespace txn::app {

/// Spectra, autocorrelations and histograms of the exemplar, its Gaussian version and a piece of
/// noise of the exemplar's size (up to 1024 x 1024); of a stack, of its first map. Errors:
/// Cancelled; those of NoiseGrid.
[[nodiscard]] Result<std::shared_ptr<const AnalysisResult>>
analyseAll(const ExemplarResult& exemplar,
           const GaussianResult& gaussian,
           const Texton& texton,
           const NoiseParams& noise,
           JobContext& context);

} // namespace txn::app
