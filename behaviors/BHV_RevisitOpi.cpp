// SPDX-License-Identifier: MIT
#include "behaviors/BHV_RevisitOpi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

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

Target TargetOf(const WatchedObject& object, double value = 0.0) {
  return {.north = object.belief.ned[0],
          .east = object.belief.ned[1],
          .window = object.window.value_or(LookWindow{}),
          .value = value};
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

RevisitInterest BHV_RevisitOpi::InterestIn(const WatchedObject& object,
                                           const Situation& now) const {
  const OpiBelief& belief = object.belief;
  RevisitInterest interest{
      .id = belief.id, .state = "open", .worth = 0.0, .fruitless = object.fruitless};
  if (belief.entropy <= params_.settled_entropy || belief.looks >= params_.settled_looks) {
    interest.state = "settled";
  } else if (object.fruitless >= params_.give_up_looks) {
    interest.state = "given_up";
  } else if (!object.window || !CanBeLookedAt(TargetOf(object), *now.region, now.turn_radius)) {
    interest.state = "out_of_reach";
  } else {
    interest.worth = params_.metres_per_nat * std::pow(params_.fruitless_decay, object.fruitless) *
                     ExpectedEntropyDrop(belief.posterior, params_.detection_probability,
                                         params_.false_alarm_probability);
  }
  return interest;
}

std::vector<RevisitInterest> BHV_RevisitOpi::Interests(const Situation& now) const {
  std::vector<RevisitInterest> interests;
  for (const WatchedObject& object : now.objects) {
    interests.push_back(InterestIn(object, now));
  }
  return interests;
}

SearchObjective BHV_RevisitOpi::Targets(const Situation& now, double weight) const {
  SearchObjective objective;
  objective.target_decay_m = params_.decay.value();
  for (const WatchedObject& object : now.objects) {
    const RevisitInterest interest = InterestIn(object, now);
    if (interest.state == "open") {
      objective.targets.push_back(TargetOf(object, weight * interest.worth));
    }
  }
  return objective;
}

void BHV_RevisitOpi::Shape(const Situation& now, double weight, SearchObjective& objective) const {
  const SearchObjective mine = Targets(now, weight);
  objective.targets.insert(objective.targets.end(), mine.targets.begin(), mine.targets.end());
  objective.target_decay_m = mine.target_decay_m;
}

void BHV_RevisitOpi::Offer(const Situation& now, std::vector<Option>& options) const {
  std::ranges::move(TargetTours(now.pose, *now.region, Targets(now, 1.0), now.turn_radius),
                    std::back_inserter(options));
}

std::optional<Bid> BHV_RevisitOpi::Value(const Prospect& prospect, const Situation& now) const {
  const SearchObjective targets = Targets(now, 1.0);
  if (targets.targets.empty()) {
    return std::nullopt;
  }
  const double worth = TargetValueOf(prospect.path(), targets);
  Bid bid{.value = worth,
          .why = {{"looks_worth", worth},
                  {"open_objects", static_cast<double>(targets.targets.size())}},
          .veto = {}};
  int fruitless = 0;
  for (const WatchedObject& object : now.objects) {
    fruitless += object.fruitless;
  }
  if (fruitless > 0) {
    bid.why.push_back({"fruitless_looks", static_cast<double>(fruitless)});
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_RevisitOpi);

}  // namespace limpet
