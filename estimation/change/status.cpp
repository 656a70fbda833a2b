// SPDX-License-Identifier: MIT
#include "estimation/change/status.hpp"

#include <algorithm>
#include <cmath>

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

Status Decide(const StatusPosterior& posterior, int looks, const StatusPriors& priors) {
  if (looks == 0) {
    return Status::kUncertain;
  }
  if (posterior.confirmed >= priors.decide_at) return Status::kConfirmed;
  if (posterior.removed >= priors.decide_at) return Status::kRemoved;
  if (posterior.appeared >= priors.decide_at) return Status::kNew;
  if (posterior.nothing >= priors.decide_at) return Status::kNothing;
  return Status::kUncertain;
}

}  // namespace limpet
