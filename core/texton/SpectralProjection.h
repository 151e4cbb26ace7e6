// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gaussian/GaussianModel.h"
#include "core/image/Image.h"
#include "core/spectral/Fft.h"
#include "core/texton/Texton.h"

#include <vector>

namespace txn {

/// The Fourier half of the alternating projections, for coefficients in the top left w x h corner
/// of the model's H x W domain. With P = t_u^ / sqrt(b^):
///     alpha^ <- P (P^* alpha^) / |P^* alpha^|,  back to the plane, cut to the corner.
/// [SOT14] algorithm 2, [TN17] algorithm 1.
///
/// Only the h rows that are not zero are transformed along x. Along y, frequency k = (H / L) q + s
/// of a column of h <= L values is frequency q of an L-point transform of the column times
/// exp(-2 pi i n s / H): H / L short transforms instead of a long one, for the shortest good
/// divisor L of H, and the full spectrum is never in memory.
///
/// Works on the model divided by its root mean square, see scale(). Uses all cores of the calling
/// task arena, with equal results for any number of them. Const members are thread-safe.
class SpectralProjection {
  public:
    SpectralProjection(const GaussianModel& model, int interpolationOrder, Size corner);

    Size corner() const { return m_corner; }
    int channels() const { return m_channels; }

    /// What coefficients found here are multiplied by to be those of the model; 0 for a model
    /// without variance.
    double scale() const { return m_scale; }

    /// One projection. Corner-sized, C channels, in and out; out may be the same image.
    void project(const Image& coefficients, Image& result) const;

    /// The same for a first guess on the whole domain: H x W x C in, corner-sized out.
    [[nodiscard]] Image projectFromDomain(const Image& guess) const;

    /// Relative model error of coefficients on the scale of this class:
    /// RME^2 = sum_{xi != 0} (|t_u^|^2 + |z|^2 - 2 |t_u^* z|) / sum_{xi != 0} |t_u^|^2,
    /// z = sqrt(b^) alpha^. [SOT14] after eq. 4; the factor 2 is missing in print.
    /// 0 for a model without variance.
    [[nodiscard]] double relativeModelError(const Image& coefficients) const;
    /// The same of a texton with one kernel, on the scale of the model.
    [[nodiscard]] double relativeModelError(const Texton& texton) const;

  private:
    struct Scratch;
    struct Sums {
        double energy = 0.0; ///< of |z|^2
        double cross = 0.0;  ///< of |t_u^* z|
    };

    void buildTarget(const GaussianModel& model);
    AlignedBuffer<Complex> forwardRows(const Image& coefficients) const;
    void inverseRows(const AlignedBuffer<Complex>& rows, Image& result) const;
    void transformResidue(const Complex* rows, int residue, Complex* spectrum) const;
    void projectBlock(int block, Complex* rows, Scratch& scratch) const;
    Sums sumBlock(int block, const Complex* rows, Scratch& scratch) const;

    std::size_t rowsPerChannel() const {
        return static_cast<std::size_t>(m_corner.height) * FftPlan::kLanes;
    }
    std::size_t residueSize() const { return static_cast<std::size_t>(m_length) * FftPlan::kLanes; }
    const Complex* target(int block, int residue) const;

    Size m_domain;
    Size m_corner;
    int m_channels;
    int m_blocks;
    int m_length;   ///< L
    int m_residues; ///< H / L
    double m_scale = 0.0;
    double m_targetEnergy = 0.0;
    std::vector<double> m_bHorizontal;
    std::vector<double> m_bVertical;
    AlignedBuffer<Complex> m_twiddles; ///< [residue][h]
    AlignedBuffer<Complex> m_target;   ///< P as [block][residue][channel][L][lane]
    FftPlan m_rowForward;
    FftPlan m_rowInverse;
    FftPlan m_columnForward;
    FftPlan m_columnInverse;
};

} // namespace txn
