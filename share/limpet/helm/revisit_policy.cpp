// SPDX-License-Identifier: MIT
#include "limpet/helm/revisit_policy.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/planning/target_tour.hpp"

namespace limpet {
namespace {

Target TargetOf(const WatchedObject& object, double value = 0.0) {
  return {.north = object.belief.object.p_W.x(),
          .east = object.belief.object.p_W.y(),
          .window = object.window.value_or(LookWindow{}),
          .value = value};
}

}  // namespace

double ExpectedEntropyDrop(const StatusPosterior& now, const PresenceLikelihood& detection) {
  const PresenceLikelihood miss{.if_present = 1.0 - detection.if_present,
                                .if_absent = 1.0 - detection.if_absent};
  double expected = 0.0;
  for (const StatusPosterior& outcome : {now.Times(detection), now.Times(miss)}) {
    expected += outcome.sum() * outcome.Normalized().Entropy();
  }
  return std::max(0.0, now.Entropy() - expected);
}

RevisitInterest RevisitPolicy::InterestIn(const WatchedObject& object, const Situation& now) const {
  const OpiBelief& belief = object.belief;
  RevisitInterest interest{
      .id = belief.id, .state = "open", .worth = 0.0, .fruitless = object.fruitless};
  if (belief.posterior.Entropy() <= params_.settled_entropy ||
      belief.looks >= params_.settled_looks) {
    interest.state = "settled";
  } else if (object.fruitless >= params_.give_up_looks) {
    interest.state = "given_up";
  } else if (!object.window || !CanBeLookedAt(TargetOf(object), *now.region, now.turn_radius)) {
    interest.state = "out_of_reach";
  } else {
    interest.worth =
        params_.metres_per_nat * std::pow(params_.fruitless_decay, object.fruitless) *
        ExpectedEntropyDrop(belief.posterior, {.if_present = params_.detection_probability,
                                               .if_absent = params_.false_alarm_probability});
  }
  return interest;
}

std::vector<RevisitInterest> RevisitPolicy::Interests(const Situation& now) const {
  std::vector<RevisitInterest> interests;
  for (const WatchedObject& object : now.objects) {
    interests.push_back(InterestIn(object, now));
  }
  return interests;
}

std::vector<Target> RevisitPolicy::OpenTargets(const Situation& now, double weight) const {
  std::vector<Target> targets;
  for (const WatchedObject& object : now.objects) {
    const RevisitInterest interest = InterestIn(object, now);
    if (interest.state == "open") {
      targets.push_back(TargetOf(object, weight * interest.worth));
    }
  }
  return targets;
}

}  // namespace limpet
