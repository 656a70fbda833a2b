// SPDX-License-Identifier: MIT
#include "estimation/attitude/inertial_gate.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/frames.hpp"

namespace limpet {

template <class Agrees>
InertialGate::Verdict InertialGate::Judge(const InertialInput& sample, Beliefs& beliefs,
                                          const Agrees& agrees) const {
  if (!beliefs.good || agrees(*beliefs.good) || (beliefs.before && agrees(*beliefs.before))) {
    beliefs = {.good = sample, .before = beliefs.good};
    return Verdict::kGood;
  }
  if (!beliefs.other || !agrees(*beliefs.other)) beliefs.other_since = sample.t;
  beliefs.other = sample;
  if (sample.t - beliefs.other_since < params_.believed_after.value()) return Verdict::kRefused;
  beliefs = {.good = sample};
  return Verdict::kBelieved;
}

double InertialGate::AgeOf(const InertialInput& former, const InertialInput& sample) const {
  return std::min(sample.t - former.t, params_.longest_growth.value());
}

InertialGate::Verdict InertialGate::JudgeMotion(const InertialInput& sample) {
  return Judge(sample, motion_, [&](const InertialInput& former) {
    const double age = AgeOf(former, sample);
    const double turn = params_.rate_jump.value() + params_.rate_growth.value() * age;
    const double push = params_.force_jump + params_.force_growth * age;
    return (sample.rate_B - former.rate_B).cwiseAbs().maxCoeff() <= turn &&
           (sample.force_B - former.force_B).cwiseAbs().maxCoeff() <= push;
  });
}

InertialGate::Verdict InertialGate::JudgeHeading(const InertialInput& sample) {
  return Judge(sample, heading_, [&](const InertialInput& former) {
    const double age = AgeOf(former, sample);
    // Of a level vehicle: at a steep pitch it explains less, over a sample's time.
    const double turned = 0.5 * (sample.rate_B.z() + former.rate_B.z()) * age;
    return std::abs(WrapAngle(sample.heading - former.heading - turned)) <=
           params_.heading_jump.value() + params_.heading_growth.value() * age;
  });
}

}  // namespace limpet
