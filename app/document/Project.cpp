// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Project.h"

namespace txn::app {

TextonParams textonParams(const TextonSettings& settings) {
    TextonParams params;
    params.support = settings.disc ? Support::disc(settings.support.width)
                                   : Support::rectangle(settings.support);
    params.interpolationOrder = settings.interpolationOrder;
    params.iterations = settings.iterations;
    params.momentum = settings.momentum;
    params.seed = settings.seed;
    return params;
}

} // namespace txn::app
