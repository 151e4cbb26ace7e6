// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/AlignedBuffer.h"
#include "core/base/Geometry.h"

#include <complex>
#include <memory>
#include <span>

namespace txn {

using Complex = std::complex<float>;

/// Smallest product of 2, 3, 5 and 7 that is at least n: fast to transform.
[[nodiscard]] int fastLength(int n);

/// One-dimensional transform of a fixed length, single precision, unnormalised both ways. Planned
/// with FFTW_ESTIMATE, so that equal input gives equal bytes on every run. Planning takes a global
/// lock; running does not and may happen on many threads at once, on buffers aligned to 64 bytes.
class FftPlan {
  public:
    /// Columns transformed side by side by the column plans.
    static constexpr int kLanes = 8;

    /// length real values -> length / 2 + 1 complex ones. The input survives.
    static FftPlan realForward(int length);
    /// length / 2 + 1 complex values -> length real ones. The input is destroyed.
    static FftPlan realInverse(int length);
    /// kLanes interleaved complex sequences (element k of lane l at k * kLanes + l), in place.
    static FftPlan columnsForward(int length);
    static FftPlan columnsInverse(int length);

    FftPlan(FftPlan&&) noexcept;
    FftPlan& operator=(FftPlan&&) noexcept;
    ~FftPlan();

    void run(const float* in, Complex* out) const;
    void run(Complex* in, float* out) const;
    void run(Complex* inOut) const;

  private:
    struct State;
    explicit FftPlan(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

/// Half of the DFT of a real H x W image: rows 0..H-1, columns 0..W/2, the rest follows by
/// symmetry. Stored in blocks of kLanes columns, each block H x kLanes, so that a block's column
/// transforms touch one contiguous piece of memory. Columns past W/2 are padding and hold zeros.
class HalfSpectrum {
  public:
    HalfSpectrum() = default;
    /// Uninitialised apart from the padding columns.
    explicit HalfSpectrum(Size imageSize);

    Size imageSize() const { return m_size; }
    int columns() const { return m_size.width / 2 + 1; }
    int blocks() const { return blocksFor(m_size.width); }
    static int blocksFor(int width) { return (width / 2 + FftPlan::kLanes) / FftPlan::kLanes; }

    std::span<Complex> block(int index) { return {m_data.data() + offset(index), blockSize()}; }
    std::span<const Complex> block(int index) const {
        return {m_data.data() + offset(index), blockSize()};
    }
    Complex& at(int row, int column) { return m_data[position(row, column)]; }
    const Complex& at(int row, int column) const { return m_data[position(row, column)]; }

    /// How often column counts in a sum over the whole DFT: 2, or 1 for column 0 and, when W is
    /// even, W/2; 0 for padding.
    int multiplicity(int column) const {
        if (column >= columns())
            return 0;
        return column == 0 || 2 * column == m_size.width ? 1 : 2;
    }

  private:
    std::size_t blockSize() const {
        return static_cast<std::size_t>(m_size.height) * FftPlan::kLanes;
    }
    std::size_t offset(int block) const { return static_cast<std::size_t>(block) * blockSize(); }
    std::size_t position(int row, int column) const {
        return offset(column / FftPlan::kLanes) + static_cast<std::size_t>(row) * FftPlan::kLanes +
               static_cast<std::size_t>(column % FftPlan::kLanes);
    }

    Size m_size;
    AlignedBuffer<Complex> m_data;
};

/// Two-dimensional transform of real H x W images, on all cores of the calling task arena; the
/// result does not depend on how many there are. DFT unnormalised forward, 1/(H W) on the inverse.
/// Const members are thread-safe.
class RealFft2d {
  public:
    explicit RealFft2d(Size size);

    Size size() const { return m_size; }

    /// plane: H * W values, row-major; offset is added to each value first.
    [[nodiscard]] HalfSpectrum forward(std::span<const float> plane, float offset = 0.0F) const;
    /// Writes H * W values. The spectrum is used as scratch memory.
    void inverse(HalfSpectrum&& spectrum, std::span<float> plane) const;

  private:
    Size m_size;
    FftPlan m_rowForward;
    FftPlan m_rowInverse;
    FftPlan m_columnForward;
    FftPlan m_columnInverse;
};

/// Cosine transform (DCT-II, unnormalised) of real H x W images: that of the image mirrored at its
/// borders. inverse() divides by 4 H W, so that it undoes forward(). One thread at a time.
class CosineTransform2d {
  public:
    explicit CosineTransform2d(Size size);
    CosineTransform2d(CosineTransform2d&&) noexcept;
    CosineTransform2d& operator=(CosineTransform2d&&) noexcept;
    ~CosineTransform2d();

    /// The H * W values to transform in place, row-major.
    std::span<float> values() { return m_values.span(); }
    void forward();
    void inverse();

  private:
    struct State;
    Size m_size;
    AlignedBuffer<float> m_values;
    std::unique_ptr<State> m_state;
};

} // namespace txn
