// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mixing/Mixture.h"
#include "core/mixing/TextonField.h"
#include "core/noise/ImpulseProcess.h"

#include <span>
#include <vector>

namespace txn {

/// The C means of a mixture at a point: the textons' own (offsets), interpolated where the smoothed
/// map lies (TextonField::meanPositions).
[[nodiscard]] std::vector<double> mixedMean(const TextonField& field,
                                            std::span<const std::vector<double>> offsets,
                                            double x,
                                            double y);

/// What all evaluators of a mixture in the plane share: the impulses, which texton each of them
/// drops (that of the map at the middle of its footprint), and the mean. [TN17] section 7:
///     g(x) = m(x) + sqrt(Q / lambda) sum_j e_j h_{r(x_j), q_j}(x - x_j),
/// m as mixedMean has it. Immutable; thread-safe.
class MixedProcess {
  public:
    /// mixture and params: checked by checkMixedNoise.
    MixedProcess(Mixture mixture, const NoiseParams& params);

    const ImpulseProcess& impulses() const { return m_impulses; }
    const std::vector<Texton>& textons() const { return m_textons; }
    /// What all textons have in common can be read from the first one.
    const Texton& first() const { return m_textons.front(); }
    int channels() const { return first().channels(); }
    /// sqrt(Q / lambda).
    double gain() const { return m_gain; }

    int textonOf(const Impulse& impulse) const {
        return m_field.textonAt(impulse.x + m_middleX, impulse.y + m_middleY, impulse.choice);
    }

    /// The C means at a point.
    [[nodiscard]] std::vector<double> meanAt(double x, double y) const {
        return mixedMean(m_field, m_offsets, x, y);
    }

    /// Adds the mean at every (xs[i], ys[j]), in exemplar pixels, to the picture.
    void addMean(std::span<const double> xs, std::span<const double> ys, Image& picture) const;

  private:
    std::vector<Texton> m_textons;
    TextonField m_field;
    ImpulseProcess m_impulses;
    double m_gain;
    double m_middleX; ///< of the footprint
    double m_middleY;
    std::vector<std::vector<double>> m_offsets; ///< of each texton alone: see Normalization
};

/// Errors: InvalidArgument for several textons where impulses have no signs (the mean could not
/// follow), or where noise repeats and the map does not.
[[nodiscard]] Result<void> checkMixing(std::size_t textons,
                                       const MapPlacement& placement,
                                       MapBoundary boundary,
                                       const NoiseParams& params);

/// Errors: those of checkMixture, checkNoiseParams and checkMixing.
[[nodiscard]] Result<void> checkMixedNoise(const Mixture& mixture, const NoiseParams& params);

} // namespace txn
