// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/MixedProcess.h"
#include "core/noise/Normalization.h"
#include "core/noise/SurfaceImpulses.h"

#include <span>

namespace txn {

/// Directions at a point of a surface: unit vectors, orthogonal. Kernels are laid with their x
/// along right and their y along down.
struct SurfaceFrame {
    glm::dvec3 right;
    glm::dvec3 down;
    glm::dvec3 normal;
};

/// Surface noise = offset + gain * (weighted sum of signed kernels), per channel. Mean and variance
/// are then those of texton noise in the plane: [TN17] proposition 3,
/// mean lambda r / 2 int h, variance lambda r / 3 int h^2.
[[nodiscard]] Normalization surfaceNormalization(const Texton& texton,
                                                 const SurfaceImpulses& impulses);

/// Noise of a texton or a mixture on a surface without texture coordinates ([TN17] section 6), at
/// any point of it, in double precision: the reference that the GPU is tested against. Impulses
/// within the cube of side r around a point, turned as its frame, are projected onto the tangent
/// plane and weigh 1 - 2 |t| / r, t their distance from it. A mixing map is what is seen from the
/// front: it lies along the x of space and against its y, which points up. Const members are
/// thread-safe.
class SurfaceNoise {
  public:
    /// mixture and params: checked by checkMixedNoise. The MNI is the mean number of impulses in
    /// the cube; since their weights differ, it takes about twice that of the plane to look the
    /// same.
    SurfaceNoise(Mixture mixture, const NoiseParams& params);

    /// Writes the C channels at a point, in exemplar pixels.
    void evaluate(const glm::dvec3& point, const SurfaceFrame& frame, std::span<double> out) const;

  private:
    std::vector<Texton> m_textons;
    TextonField m_field;
    SurfaceImpulses m_impulses;
    double m_gain;
    std::vector<std::vector<double>> m_offsets; ///< of each texton alone: see Normalization
};

} // namespace txn
