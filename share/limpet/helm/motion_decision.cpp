// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_decision.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/frames.hpp"
#include "limpet/helm/behavior_failure_warnings.hpp"
#include "limpet/helm/peak_points.hpp"

namespace limpet {
namespace {

template <class Bid>
auto& PeakOf(Bid& bid, MotionVariable variable) {
  return variable == MotionVariable::kCourse  ? bid.course
         : variable == MotionVariable::kSpeed ? bid.speed
                                              : bid.depth;
}

/// Why a peak is none, or nothing.
std::optional<std::string> ProblemOf(const Peak& peak, MotionVariable variable) {
  const bool is_finite = std::isfinite(peak.summit) && std::isfinite(peak.flat_half_width) &&
                         std::isfinite(peak.base_half_width);
  if (!is_finite) return fmt::format("NaN or infinity in its bid on {}", NameOf(variable));
  if (!(peak.flat_half_width >= 0.0 && peak.base_half_width > peak.flat_half_width)) {
    return fmt::format("a base of {:g} under a flat top of {:g} in its bid on {}",
                       peak.base_half_width, peak.flat_half_width, NameOf(variable));
  }
  if (!(peak.edge_value >= 0.0 && peak.edge_value <= 1.0)) {
    return fmt::format("an edge beyond 0 to 1 in its bid on {}", NameOf(variable));
  }
  if (!(peak.share >= 0.0 && std::isfinite(peak.share))) {
    return fmt::format("a share of {:g} in its bid on {}", peak.share, NameOf(variable));
  }
  return std::nullopt;
}

/// Why a bid cannot be heard, or nothing.
std::optional<std::string> ProblemOf(const MotionBid& bid, const MotionDomain& domain) {
  for (const MotionVariable variable : kMotionVariables) {
    if (const std::optional<Peak>& peak = PeakOf(bid, variable)) {
      if (auto problem = ProblemOf(*peak, variable)) return problem;
    }
  }
  if (bid.present_course) {
    if (auto problem = ProblemOf(*bid.present_course, MotionVariable::kCourse)) return problem;
  }
  if (bid.turn_rate && !std::isfinite(*bid.turn_rate)) return "NaN or infinity in its turn rate";
  if (bid.table == nullptr) return std::nullopt;
  if (bid.table->domain() != domain) return "its function was made for another domain";
  return bid.table->Problem();
}

/// True if the bid has an opinion on a variable that the domain has.
bool HasOpinion(const MotionBid& bid, const MotionDomain& domain) {
  return std::ranges::any_of(kMotionVariables, [&](MotionVariable variable) {
    return domain.axis(variable) &&
           (PeakOf(bid, variable) || (bid.table != nullptr && bid.table->Covers(variable)));
  });
}

double PresentValue(const VehicleState& state, MotionVariable variable) {
  return variable == MotionVariable::kCourse  ? WrapAngle(state.nav.yaw)
         : variable == MotionVariable::kSpeed ? std::hypot(state.nav.u, state.nav.v)
                                              : state.nav.down;
}

}  // namespace

const std::optional<double>& MotionDecision::value(MotionVariable variable) const {
  return variable == MotionVariable::kCourse  ? course
         : variable == MotionVariable::kSpeed ? speed
                                              : depth;
}

std::string MotionDecision::Missing(const MotionDomain& domain) const {
  std::string names;
  for (const MotionVariable variable : kMotionVariables) {
    const std::optional<MotionAxis>& axis = domain.axis(variable);
    if (axis && !axis->is_optional && !value(variable)) {
      names += (names.empty() ? "" : ",") + std::string(NameOf(variable));
    }
  }
  return names;
}

const MotionDecision& MotionArbiter::Decide(std::span<const WeightedBehavior> behaviors,
                                            const VehicleState& state) {
  decision_.warnings.clear();
  decision_.failures.clear();
  heard_ = 0;
  acted_ = 0;
  const Seconds began = watch_.Now();
  for (const WeightedBehavior& running : behaviors) {
    Ask(running, state);
  }
  asked_for_ = watch_.Now() - began;
  decision_.turns.resize(acted_);
  for (std::vector<WeightedPeak>& peaks : peaks_) {
    peaks.clear();
  }
  tables_.clear();
  std::size_t active = 0;
  decision_.has_goal = false;
  for (const OwnedMotionBid& owned : bids()) {
    Add(owned);
    if (!HasOpinion(owned.bid, domain_)) continue;
    decision_.has_goal = decision_.has_goal || !owned.is_constraint;
    if (decision_.active.size() == active) decision_.active.emplace_back();
    decision_.active[active++] = owned.owner;
  }
  decision_.active.resize(active);
  Choose(state);
  return decision_;
}

void MotionArbiter::Ask(const WeightedBehavior& running, const VehicleState& state) {
  if (bids_.size() == heard_) bids_.emplace_back();
  OwnedMotionBid& owned = bids_[heard_];
  if (!Hear(running, state, owned)) return;
  if (const auto problem = ProblemOf(owned.bid, domain_)) return Fail(running.name, *problem);
  if (owned.bid.warning) {
    decision_.warnings.push_back({.owner = running.name, .warning = *owned.bid.warning});
  }
  if (is_at_points_) StandAtPoints(owned.bid);
  owned.owner = running.name;
  owned.weight = running.weight;
  NoteUnheard(owned);
  ++heard_;
}

/// An opinion that nobody can follow would else be taken for one that is.
void MotionArbiter::NoteUnheard(const OwnedMotionBid& owned) {
  if (HasOpinion(owned.bid, domain_)) return;
  for (const MotionVariable variable : kMotionVariables) {
    if (!PeakOf(owned.bid, variable)) continue;
    decision_.warnings.push_back(
        {.owner = owned.owner,
         .warning = {
             warnings::kBidUnheard.Of(owned.owner),
             fmt::format("it bids on {}, which the domain does not have", NameOf(variable))}});
    return;
  }
}

void MotionArbiter::StandAtPoints(MotionBid& bid) const {
  for (const MotionVariable variable : kMotionVariables) {
    const std::optional<MotionAxis>& axis = domain_.axis(variable);
    std::optional<Peak>& peak = PeakOf(bid, variable);
    if (peak && axis) peak = StandingAtPoints(*peak, *axis, variable);
  }
}

bool MotionArbiter::Hear(const WeightedBehavior& running, const VehicleState& state,
                         OwnedMotionBid& owned) {
  std::optional<BehaviorFailure> failure;
  bool is_asked = false;
  const auto late = watch_.Ask(running.name, [&] {
    is_asked = true;
    failure = FailureOf(running.name, [&] {
      owned.bid = running.behavior->Move(state);
      owned.is_constraint = running.behavior->IsConstraint();
    });
  });
  if (late) decision_.warnings.push_back(LatenessOf(running.name, *late));
  if (failure) Fail(failure->owner, failure->text);
  if (failure || !is_asked) return false;
  NoteTurn(running.name, owned.bid.acts);  // what it did counts, also if it was late
  return !late && running.weight > 0.0;    // without a weight it acts, and has no say
}

void MotionArbiter::NoteTurn(const std::string& name, std::vector<BehaviorAct>& acts) {
  if (decision_.turns.size() == acted_) decision_.turns.emplace_back();
  BehaviorTurn& turn = decision_.turns[acted_++];
  turn.name = name;
  turn.acts = std::move(acts);
  acts.clear();
}

void MotionArbiter::Fail(const std::string& owner, const std::string& text) {
  decision_.failures.push_back({.owner = owner, .text = text});
  decision_.warnings.push_back(
      {.owner = owner, .warning = {warnings::kBehaviorFailed.Of(owner), text}});
}

void MotionArbiter::Add(const OwnedMotionBid& owned) {
  for (const MotionVariable variable : kMotionVariables) {
    const std::optional<Peak>& peak = PeakOf(owned.bid, variable);
    if (peak && domain_.axis(variable)) {
      peaks_.at(IndexOf(variable)).push_back({*peak, owned.weight * peak->share});
    }
  }
  if (const std::optional<Peak>& present = owned.bid.present_course; present && domain_.course) {
    peaks_.at(IndexOf(MotionVariable::kCourse))
        .push_back({*present, owned.weight * present->share});
  }
  if (owned.bid.table != nullptr) tables_.push_back({owned.bid.table, owned.weight});
}

/// The heaviest peak's summit: what the decision would be if the others did not mind.
double MotionArbiter::Reference(MotionVariable variable, double present) const {
  const std::vector<WeightedPeak>& peaks = peaks_.at(IndexOf(variable));
  const auto heaviest = std::ranges::max_element(peaks, {}, &WeightedPeak::weight);
  if (heaviest == peaks.end()) return present;
  const double summit = heaviest->peak.summit;
  return variable == MotionVariable::kCourse ? WrapAngle(summit) : summit;
}

void MotionArbiter::Choose(const VehicleState& state) {
  std::array<double, 3> reference{};
  for (const MotionVariable variable : kMotionVariables) {
    reference.at(IndexOf(variable)) = Reference(variable, PresentValue(state, variable));
  }
  std::array<std::optional<double>, 3> chosen =
      search_.Maximise({.tables = tables_, .peaks = {peaks_[0], peaks_[1], peaks_[2]}}, reference);
  const bool is_course_joined = chosen[0].has_value();
  for (const MotionVariable variable : kMotionVariables) {
    std::optional<double>& value = chosen.at(IndexOf(variable));
    const std::vector<WeightedPeak>& peaks = peaks_.at(IndexOf(variable));
    const std::optional<MotionAxis>& axis = domain_.axis(variable);
    if (value || peaks.empty()) continue;
    value = is_at_points_ ? MaximizeOverPoints(peaks, *axis, variable)
            : variable == MotionVariable::kCourse
                ? MaximizeOverCircle(peaks)
                : MaximizeOverInterval(peaks, {axis->low, axis->high});
  }
  decision_.course = chosen[0];
  decision_.speed = chosen[1];
  decision_.depth = chosen[2];
  ChooseTurnRate(is_course_joined);
}

/// Feed-forward of another course than the one that was chosen would lead away from it.
void MotionArbiter::ChooseTurnRate(bool is_course_joined) {
  decision_.turn_rate.reset();
  double heaviest = 0.0;
  double summit = 0.0;
  for (const OwnedMotionBid& owned : bids()) {
    if (owned.bid.course && owned.weight > heaviest) {
      heaviest = owned.weight;
      summit = owned.bid.course->summit;
      decision_.turn_rate = owned.bid.turn_rate;
    }
  }
  if (is_course_joined &&
      std::abs(WrapAngle(*decision_.course - summit)) > domain_.course->step()) {
    decision_.turn_rate.reset();
  }
}

MotionDecision DecideMotion(std::span<const WeightedBehavior> behaviors, const VehicleState& state,
                            const MotionDomain& domain) {
  return MotionArbiter(domain).Decide(behaviors, state);
}

}  // namespace limpet
