// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/TextonSolver.h"

#include "core/gaussian/Variation.h"
#include "core/gaussian/WhiteNoise.h"
#include "core/spectral/BSpline.h"

#include <string>

namespace txn {
namespace {

/// The first iterations change too much to be extrapolated.
constexpr int kPlainIterations = 3;

Result<void> check(const GaussianModel& model, const TextonParams& params) {
    const Size support = params.support.size();
    const Size domain = model.domain();
    if (support.width > domain.width || support.height > domain.height)
        return Error{ErrorCode::SizeMismatch,
                     "the support of " + sizeText(support) + " is larger than the exemplar of " +
                         sizeText(domain) + "; choose a smaller support"};
    if (!isInterpolationOrder(params.interpolationOrder))
        return Error{ErrorCode::InvalidArgument, "the interpolation order must be 0, 1, 3 or 5"};
    if (params.iterations < 1 || params.iterations > 100000)
        return Error{ErrorCode::InvalidArgument, "iterations must be between 1 and 100000"};
    if (!(params.momentum >= 0.0 && params.momentum < 1.0))
        return Error{ErrorCode::InvalidArgument, "momentum must be at least 0 and below 1"};
    if (!varies(model))
        return Error{ErrorCode::Degenerate,
                     "the exemplar is one flat colour: there is no texture to summarise"};
    return {};
}

} // namespace

Result<TextonSolver> TextonSolver::create(const GaussianModel& model, const TextonParams& params) {
    if (const auto ok = check(model, params); !ok)
        return ok.error();
    return TextonSolver(model,
                        params,
                        whiteNoise(params.support.size(), model.channels(), params.seed));
}

Result<TextonSolver>
TextonSolver::create(const GaussianModel& model, const TextonParams& params, Image initialNoise) {
    if (const auto ok = check(model, params); !ok)
        return ok.error();
    if (initialNoise.channels() != model.channels() ||
        (initialNoise.size() != model.domain() && initialNoise.size() != params.support.size()))
        return Error{ErrorCode::SizeMismatch,
                     "the initial noise must have the size of the exemplar or of the support"};
    return TextonSolver(model, params, std::move(initialNoise));
}

TextonSolver::TextonSolver(const GaussianModel& model,
                           const TextonParams& params,
                           Image initialNoise)
    : m_params(params), m_projection(model, params.interpolationOrder, params.support.size()),
      m_mean(model.mean()), m_transfer(model.transfer()), m_next(std::move(initialNoise)),
      m_current(params.support.size(), model.channels()), m_previous(m_current) {
    if (m_next.size() == params.support.size())
        cutToSupport(m_next);
}

void TextonSolver::cutToSupport(Image& coefficients) const {
    if (m_params.support.shape() == SupportShape::Rectangle)
        return; // the projection cuts to the rectangle itself
    for (int c = 0; c < coefficients.channels(); ++c) {
        for (int y = 0; y < coefficients.height(); ++y) {
            for (int x = 0; x < coefficients.width(); ++x) {
                if (!m_params.support.contains(x, y))
                    coefficients.at(x, y, c) = 0.0F;
            }
        }
    }
}

void TextonSolver::step() {
    if (done())
        return;
    std::swap(m_previous, m_current);
    if (m_next.size() == m_projection.corner())
        m_projection.project(m_next, m_current);
    else
        m_current = m_projection.projectFromDomain(m_next);
    cutToSupport(m_current);
    ++m_iteration;

    m_next = m_current;
    if (m_params.momentum > 0.0 && m_iteration >= kPlainIterations) {
        const auto momentum = static_cast<float>(m_params.momentum);
        const auto now = m_current.samples();
        const auto before = m_previous.samples();
        const auto next = m_next.samples();
        for (std::size_t i = 0; i < next.size(); ++i)
            next[i] = now[i] + momentum * (now[i] - before[i]);
    }
}

Texton TextonSolver::texton() const {
    Image kernel = m_current;
    kernel.setTransfer(m_transfer);
    const auto scale = static_cast<float>(m_projection.scale());
    for (float& v : kernel.samples())
        v *= scale;
    return {{std::move(kernel)}, m_params.support, m_params.interpolationOrder, m_mean, m_transfer};
}

double TextonSolver::relativeModelError() const {
    return m_projection.relativeModelError(m_current);
}

double TextonSolver::relativeModelError(const Texton& texton) const {
    return m_projection.relativeModelError(texton);
}

} // namespace txn
