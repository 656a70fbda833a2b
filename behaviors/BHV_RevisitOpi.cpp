// SPDX-License-Identifier: MIT
#include "behaviors/BHV_RevisitOpi.hpp"

#include <array>
#include <cmath>

#include "limpet/helm/registry.hpp"
#include "limpet/planning/target_tour.hpp"

namespace limpet {
namespace {

using FourWay = std::array<double, 4>;  // confirmed, removed, appeared, nothing

double Entropy(const FourWay& p) {
  double sum = 0.0;
  for (const double share : p) {
    sum -= share > 0.0 ? share * std::log(share) : 0.0;
  }
  return sum;
}

/// Posterior after evidence with these likelihoods, and its probability.
double Update(const FourWay& prior, const FourWay& likelihood, FourWay& posterior) {
  double evidence = 0.0;
  for (std::size_t i = 0; i < prior.size(); ++i) {
    posterior[i] = prior[i] * likelihood[i];
    evidence += posterior[i];
  }
  for (double& share : posterior) {
    share = evidence > 0.0 ? share / evidence : 0.0;
  }
  return evidence;
}

}  // namespace

double ExpectedEntropyDrop(const ChangePosterior& now, double detection, double false_alarm) {
  const FourWay prior{now.confirmed, now.removed, now.appeared, now.nothing};
  const FourWay hit{detection, false_alarm, detection, false_alarm};
  const FourWay miss{1.0 - detection, 1.0 - false_alarm, 1.0 - detection, 1.0 - false_alarm};
  FourWay after{};
  double expected = 0.0;
  for (const FourWay& outcome : {hit, miss}) {
    const double probability = Update(prior, outcome, after);
    expected += probability * Entropy(after);
  }
  return std::max(0.0, Entropy(prior) - expected);
}

SearchObjective BHV_RevisitOpi::Targets(const Situation& now, double weight) const {
  SearchObjective objective;
  objective.target_decay_m = params_.decay.value();
  for (const OpiBelief& opi : now.opis) {
    const bool is_settled =
        opi.entropy <= params_.settled_entropy || opi.looks >= params_.settled_looks;
    if (is_settled) {
      continue;
    }
    const double drop = ExpectedEntropyDrop(opi.posterior, params_.detection_probability,
                                            params_.false_alarm_probability);
    objective.targets.push_back({.north = opi.ned[0],
                                 .east = opi.ned[1],
                                 .radius = params_.look_radius.value(),
                                 .value = weight * params_.metres_per_nat * drop});
  }
  return objective;
}

void BHV_RevisitOpi::Shape(const Situation& now, double weight, SearchObjective& objective) const {
  const SearchObjective mine = Targets(now, weight);
  objective.targets.insert(objective.targets.end(), mine.targets.begin(), mine.targets.end());
  objective.target_decay_m = mine.target_decay_m;
}

void BHV_RevisitOpi::Offer(const Situation& now, std::vector<Option>& options) const {
  std::optional<Option> tour =
      TargetTour(now.pose, *now.region, Targets(now, 1.0), now.turn_radius);
  if (tour) {
    options.push_back(std::move(*tour));
  }
}

std::optional<Bid> BHV_RevisitOpi::Value(const Prospect& prospect, const Situation& now) const {
  const SearchObjective targets = Targets(now, 1.0);
  if (targets.targets.empty()) {
    return std::nullopt;
  }
  const double worth = TargetValueOf(prospect.path(), targets);
  return Bid{.value = worth,
             .why = {{"looks_worth", worth},
                     {"open_objects", static_cast<double>(targets.targets.size())}},
             .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_RevisitOpi);

}  // namespace limpet
