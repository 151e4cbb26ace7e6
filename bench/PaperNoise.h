// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/NoiseParams.h"
#include "core/texton/Texton.h"
#include "gl/GlHandle.h"
#include "gl/OffscreenTarget.h"
#include "gl/ShaderProgram.h"

namespace txn::bench {

/// Texton noise evaluated as in [TN17] section 8, for comparison: a Poisson process of
/// kMeanImpacts, simulated on the fly in cells of kCellShare of the footprint by a xorshift
/// generator seeded with a hash of the cell, and one fetch by the hardware's bilinear filter per
/// impact. Counts are drawn exactly, where the authors round Gaussian ones. Move-only.
class PaperNoise {
  public:
    static constexpr double kMeanImpacts = 30.0;
    static constexpr double kCellShare = 0.6;

    /// texton: one kernel of order 1, 1 to 4 channels.
    [[nodiscard]] static Result<PaperNoise>
    create(const GlContext& context, const Texton& texton, Seed seed);

    /// The plane seen from above, one pixel per exemplar pixel, its origin in the middle.
    void draw(const OffscreenTarget& target);

    /// Draws once and compares mean and standard deviations with those that the texton promises.
    /// Errors: Degenerate where they are more than 5 % of the standard deviation apart.
    [[nodiscard]] Result<void> check(const GlContext& context, const Texton& texton);

  private:
    ShaderProgram m_program;
    GlHandle m_vertices;
    GlHandle m_kernel;
};

} // namespace txn::bench
