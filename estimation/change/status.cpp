// SPDX-License-Identifier: MIT
#include "estimation/change/status.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/change/log_space.hpp"
#include "limpet/core/logistic.hpp"

namespace limpet {

namespace {

/// ln of what this session saw where an object is, where one was and is gone, and where none was.
struct SeenNow {
  double present = 0.0, gone = 0.0, never = 0.0;
};

StatusPosterior Weigh(double lambda_former, const SeenNow& now, const StatusPriors& priors) {
  const double c =
      std::log(priors.presence) + std::log(priors.survival) + lambda_former + now.present;
  const double r =
      std::log(priors.presence) + std::log1p(-priors.survival) + lambda_former + now.gone;
  const double n = std::log1p(-priors.presence) + std::log(priors.appearance) + now.present;
  const double none = std::log1p(-priors.presence) + std::log1p(-priors.appearance) + now.never;
  const double high = std::max({c, r, n, none});
  const StatusPosterior weight{.confirmed = std::exp(c - high),
                               .removed = std::exp(r - high),
                               .appeared = std::exp(n - high),
                               .nothing = std::exp(none - high)};
  return weight.Normalized();
}

/// Chance of a lookalike now where there was no object, after what the former session saw. From
/// P(lookalike | seen then) = l P(seen | lookalike) / P(seen | no object), where a lookalike is
/// taken to be seen as an object is.
double LookalikeNow(double lambda_former, const StatusPriors& priors) {
  const double then = std::min(1.0, priors.lookalike * std::exp(std::min(lambda_former, 100.0)));
  const double still = priors.lookalike_survival * then;
  return std::min(still + (1.0 - still) * priors.lookalike, 1.0 - 1e-9);
}

}  // namespace

StatusPosterior ChangeStatus(const SessionLambdas& lambda, const StatusPriors& priors) {
  return Weigh(lambda.former, {.present = lambda.now}, priors);
}

StatusPosterior DiscoveryStatus(double lambda_now, const StatusPriors& priors) {
  const double log_odds = std::log(priors.presence) - std::log1p(-priors.presence) + lambda_now;
  return {.confirmed = 0.0,
          .removed = 0.0,
          .appeared = Logistic(log_odds),
          .nothing = Logistic(-log_odds)};
}

StatusPosterior ChangeStatus(double lambda_former, const PlaceEvidence& now,
                             const VisibilityBelief& water, const StatusPriors& priors) {
  const PerVisibility gone = now.Absent(priors.lookalike);
  const PerVisibility never = now.Absent(LookalikeNow(lambda_former, priors));
  StatusPosterior sum{.confirmed = 0.0, .removed = 0.0, .appeared = 0.0, .nothing = 0.0};
  for (int i = 0; i < PerVisibility::kCount; ++i) {
    const SeenNow seen{.present = now.present(i), .gone = gone(i), .never = never(i)};
    sum.Add(Weigh(lambda_former, seen, priors), water.chances()(i));
  }
  return sum;
}

StatusPosterior DiscoveryStatus(const PlaceEvidence& now, const VisibilityBelief& water,
                                const StatusPriors& priors) {
  return DiscoveryStatus(LambdaIn(water, now.Lambda(priors.lookalike), priors), priors);
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
