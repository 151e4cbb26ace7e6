// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/RelativeModelError.h"

#include "core/texton/SpectralProjection.h"

namespace txn {

Result<double> relativeModelError(const GaussianModel& model, const Texton& texton) {
    const Size support = texton.support.size();
    if (texton.kernelCount() != 1)
        return Error{ErrorCode::Unsupported,
                     "the relative model error is defined for textons with one kernel"};
    if (texton.channels() != model.channels())
        return Error{ErrorCode::SizeMismatch,
                     "the texton has " + std::to_string(texton.channels()) +
                         " channels and the exemplar " + std::to_string(model.channels())};
    if (support.width > model.domain().width || support.height > model.domain().height)
        return Error{ErrorCode::SizeMismatch, "the texton is larger than the exemplar"};
    const SpectralProjection projection(model, texton.interpolationOrder, support);
    if (!(projection.scale() > 0.0))
        return Error{ErrorCode::Degenerate, "the exemplar has no variation"};
    return projection.relativeModelError(texton);
}

} // namespace txn
