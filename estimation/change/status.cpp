// SPDX-License-Identifier: MIT
#include "estimation/change/status.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/change/log_space.hpp"

namespace limpet {

StatusPosterior ChangeStatus(double lambda_former, double lambda_now, const StatusPriors& priors) {
  const double c =
      std::log(priors.presence) + std::log(priors.survival) + lambda_former + lambda_now;
  const double r = std::log(priors.presence) + std::log1p(-priors.survival) + lambda_former;
  const double n = std::log1p(-priors.presence) + std::log(priors.appearance) + lambda_now;
  const double none = std::log1p(-priors.presence) + std::log1p(-priors.appearance);
  const double high = std::max({c, r, n, none});
  const StatusPosterior weight{.confirmed = std::exp(c - high),
                               .removed = std::exp(r - high),
                               .appeared = std::exp(n - high),
                               .nothing = std::exp(none - high)};
  return weight.Normalized();
}

StatusPosterior DiscoveryStatus(double lambda_now, const StatusPriors& priors) {
  const double log_odds = std::log(priors.presence) - std::log1p(-priors.presence) + lambda_now;
  return {.confirmed = 0.0,
          .removed = 0.0,
          .appeared = 1.0 / (1.0 + std::exp(-log_odds)),
          .nothing = 1.0 / (1.0 + std::exp(log_odds))};
}

StatusPosterior ChangeStatus(double lambda_former, const PerVisibility& lambda_now,
                             const VisibilityBelief& water, const StatusPriors& priors) {
  StatusPosterior sum{.confirmed = 0.0, .removed = 0.0, .appeared = 0.0, .nothing = 0.0};
  for (int i = 0; i < PerVisibility::kCount; ++i) {
    sum.Add(ChangeStatus(lambda_former, lambda_now(i), priors), water.chances()(i));
  }
  return sum;
}

StatusPosterior DiscoveryStatus(const PerVisibility& lambda_now, const VisibilityBelief& water,
                                const StatusPriors& priors) {
  return DiscoveryStatus(LambdaIn(water, lambda_now, priors), priors);
}

double LambdaIn(const VisibilityBelief& water, const PerVisibility& lambda,
                const StatusPriors& priors) {
  const double before = std::log(priors.presence) - std::log1p(-priors.presence);
  const PerVisibility log_odds = before + lambda;
  const auto log_mean = [&](double sign) {  // of 1 / (1 + e^(sign log_odds))
    const PerVisibility logs =
        log_odds.unaryExpr([sign](double x) { return -LogSum(0.0, sign * x); });
    const double high = logs.maxCoeff();
    return high +
           std::log(water.Expect(logs.unaryExpr([high](double x) { return std::exp(x - high); })));
  };
  return log_mean(-1.0) - log_mean(1.0) - before;
}

Status Decide(const StatusPosterior& posterior, int looks, const StatusPriors& priors) {
  if (looks == 0) {
    return Status::kNotInspected;
  }
  if (posterior.confirmed >= priors.decide_at) return Status::kConfirmed;
  if (posterior.removed >= priors.decide_at) return Status::kRemoved;
  if (posterior.appeared >= priors.decide_at) return Status::kNew;
  if (posterior.nothing >= priors.decide_at) return Status::kNothing;
  return Status::kUncertain;
}

}  // namespace limpet
