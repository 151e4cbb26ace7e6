// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/JudgementJob.h"

namespace txn::app {

std::shared_ptr<const Judgement> judge(const ExemplarResult& exemplar, JobContext& context) {
    auto judgement = std::make_shared<Judgement>();
    const auto note = [&](const Result<Suitability>& suitability) {
        if (suitability)
            judgement->suitability = *suitability;
    };
    if (exemplar.exemplar.maps.empty()) {
        note(assessSuitability(exemplar.exemplar, exemplar.model, context.token()));
    } else {
        const Exemplar first{exemplar.pictures.front().image(), exemplar.exemplar.name};
        const GaussianModel model(first, exemplar.model.isPeriodicComponent());
        note(assessSuitability(first, model, context.token()));
    }
    if (context.cancelled())
        return judgement;
    if (const auto support = suggestSupport(exemplar.exemplar))
        judgement->support = *support;
    return judgement;
}

} // namespace txn::app
