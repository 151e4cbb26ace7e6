// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Result.h"
#include "core/noise/TileEvaluator.h"

namespace txn {

/// Noise of a texton or a mixture on the pixels of the plane. Any rectangle may be asked for, near
/// the origin or far away; a pixel has the same bits whichever rectangle it is part of and however
/// many threads work. scale: output pixels per exemplar pixel, 1/64 to 64; pixel n covers [n, n +
/// 1) / scale. Const members are thread-safe.
class NoiseGrid {
  public:
    static constexpr double kMinScale = 1.0 / 64.0;
    static constexpr double kMaxScale = 64.0;

    /// Errors: those of checkMixedNoise; InvalidArgument for a scale out of range.
    [[nodiscard]] static Result<NoiseGrid>
    create(Mixture mixture, const NoiseParams& params, double scale = 1.0);

    int channels() const { return m_channels; }
    Transfer transfer() const { return m_transfer; }
    /// Rectangles of whole tiles cost least. Tile (0, 0) starts at pixel (0, 0).
    Size tileSize() const { return m_evaluator->tileSize(); }

    /// Errors: InvalidArgument where the rectangle is empty or leaves the plane (1e8 exemplar
    /// pixels from the origin). Cancelled.
    [[nodiscard]] Result<Image> render(const Rect& rect, const CancelToken& cancel = {}) const;

  private:
    NoiseGrid(std::unique_ptr<TileEvaluator> evaluator,
              int channels,
              Transfer transfer,
              double scale)
        : m_evaluator(std::move(evaluator)), m_channels(channels), m_transfer(transfer),
          m_scale(scale) {}

    std::unique_ptr<TileEvaluator> m_evaluator;
    int m_channels;
    Transfer m_transfer;
    double m_scale;
};

} // namespace txn
