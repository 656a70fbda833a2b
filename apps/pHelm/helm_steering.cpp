// SPDX-License-Identifier: MIT
// How now: what is decided of the motion, and who is told.
#include <algorithm>
#include <string>
#include <utility>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/helm/ipf_text.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

void HelmApp::Steer(const VehicleState& state) {
  const std::vector<WeightedBehavior> bidders = Bidders();
  motion_ = arbiter_.Decide(bidders, state);
  const MotionDecision& decision = motion_;
  if (!lead_.leads() && motion_rate_.IsDue(decision, state.now)) {
    Publish(topics::kHelmMotion, RecordOf(arbiter_, decision));
  }
  if (params_.post_ipf) PublishFunctions();
  if (std::ranges::any_of(decision.turns, &BehaviorTurn::IsEmergency)) {
    AllStop("BehaviorError");
  } else if (lead_.leads()) {
    Lead();
  } else {
    Drive();
  }
}

void HelmApp::PublishFunctions() {
  int pieces = 0;
  for (const OwnedMotionBid& owned : arbiter_.bids()) {
    const std::string text = IpfText(owned, arbiter_.domain(), helm_iteration_);
    pieces += IpfPieces(text);
    for (std::string& packet : IpfPackets(text, owned.owner, helm_iteration_)) {
      PublishRaw(topics::kBehaviorFunction.name, std::move(packet), owned.owner);
    }
  }
  journal_.PostPieces(pieces);
}

void HelmApp::Lead() {
  const bool has_path = !planner_.path().segments().empty();
  if (motion_.active.empty() && !has_path) {
    AllStop("NothingToDo");
    return;
  }
  ClearAllStop();
  lead_.Steer(has_path, motion_);
}

void HelmApp::Drive() {
  const MotionDecision& decision = motion_;
  if (decision.active.empty()) {
    AllStop("NothingToDo");
    return;
  }
  if (params_.goals_mandatory && !decision.has_goal) {
    AllStop("NoGoalBehavior");
    return;
  }
  if (const std::string missing = decision.Missing(arbiter_.domain()); !missing.empty()) {
    const std::string why = "MissingDecVars:" + missing;
    if (allstop_text_ != why) Publish(topics::kBehaviorError, why);
    AllStop(why);
    return;
  }
  ClearAllStop();
  if (decision.course) Ask(topics::kDesiredHeading, MoosHeadingFromYaw(*decision.course));
  if (decision.speed) Ask(topics::kDesiredSpeed, *decision.speed);
  if (decision.depth) Ask(topics::kDesiredDepth, *decision.depth);
  Ask(topics::kDesiredTurnRate, decision.turn_rate.value_or(0.0));
}

void HelmApp::Ask(const Topic<double>& topic, double value) {
  if (params_.helm_prefix.empty()) {
    Publish(topic, value);
  } else {
    PublishRaw(params_.helm_prefix + std::string(topic.name), value);
  }
}

/// All that it decides on, to 0. A prefix makes no difference: who drives must hear it, and so must
/// who hears the prefix.
void HelmApp::AskForNothing() {
  const auto zero = [this](const Topic<double>& topic) {
    Publish(topic, 0.0);
    if (!params_.helm_prefix.empty()) Ask(topic, 0.0);
  };
  zero(topics::kDesiredSpeed);
  zero(topics::kDesiredTurnRate);
  if (arbiter_.domain().depth) zero(topics::kDesiredDepth);
  // As pHelmIvP; a pilot of ours would turn to the north on the spot.
  if (params_.at_points) zero(topics::kDesiredHeading);
}

void HelmApp::AllStop(const std::string& why) {
  // One iteration without a decision is held off: one behavior may hand over to another by a flag.
  const bool is_empty =
      why == "NothingToDo" || why == "NoGoalBehavior" || why.starts_with("MissingDecVars");
  empty_decisions_ = is_empty ? empty_decisions_ + 1 : 0;
  allstop_text_ = why;
  if (empty_decisions_ == 1) return;
  if (lead_.leads()) {
    lead_.Stop();
  } else if (params_.at_points || stopped_for_ != why) {
    // Once: a pilot of ours that hears nothing more goes to zero by itself. In a stock helm's place
    // each time, as that does.
    AskForNothing();
  }
  stopped_for_ = why;
}

void HelmApp::ClearAllStop() {
  allstop_text_ = topics::kNoAllStop;
  stopped_for_.clear();
  empty_decisions_ = 0;
}

std::optional<double> HelmApp::last_course_deg() const {
  return motion_.course ? std::optional<double>(MoosHeadingFromYaw(*motion_.course)) : std::nullopt;
}

}  // namespace limpet
