// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "limpet/helm/answer_watch.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/behavior_act.hpp"
#include "limpet/helm/behavior_failure.hpp"
#include "limpet/helm/motion_domain.hpp"
#include "limpet/helm/motion_grid_search.hpp"
#include "limpet/helm/view_decision.hpp"
#include "limpet/helm/warning_book.hpp"

namespace limpet {

/// What one behavior bid on the motion, and its weight.
struct OwnedMotionBid {
  std::string owner;
  double weight = 1.0;
  MotionBid bid;
  bool is_constraint = false;  ///< of a behavior that has no goal of its own
};

/// What the helm asks of the vehicle now.
struct MotionDecision {
  std::optional<double> course;     ///< [rad]
  std::optional<double> speed;      ///< [m/s]
  std::optional<double> depth;      ///< [m]
  std::optional<double> turn_rate;  ///< feed-forward of the heaviest bidder on course [rad/s]
  std::vector<OwnedWarning> warnings;
  std::vector<BehaviorTurn> turns;        ///< of all running behaviors that did not fail
  std::vector<BehaviorFailure> failures;  ///< these are in `warnings`, too
  std::vector<std::string> active;        ///< names of behaviors that had an opinion
  bool has_goal = false;                  ///< one of these is no constraint

  [[nodiscard]] const std::optional<double>& value(MotionVariable variable) const;
  /// Names of the domain's variables that nobody bid on and that are not optional, e.g.
  /// "course,depth"; "" if complete.
  [[nodiscard]] std::string Missing(const MotionDomain& domain) const;
};

/// "How now": preferences over course, speed and depth, weighted, summed, maximised exactly. Peaks
/// alone decide their variable over the continuum (peak.hpp). Variables that a table joins are
/// decided together over the domain's points, peaks among them (motion_grid_search.hpp); of points
/// as good, the nearest to the summit of the heaviest peak on the variable, or to the present value
/// where there is no peak. A behavior that throws, or bids a number that is none, is not heard in
/// this decision; the others are. While the same behaviors run and none of them warns, deciding
/// allocates nothing.
class MotionArbiter {
 public:
  /// With a `clock`, behaviors that answer late are not heard. `is_at_points`: peaks alone
  /// decide over the domain's points, too, as in MOOS-IvP (peak_points.hpp).
  explicit MotionArbiter(const MotionDomain& domain, RealClock clock = {},
                         bool is_at_points = false)
      : domain_(domain), search_(domain), watch_(std::move(clock)), is_at_points_(is_at_points) {}

  /// Valid until the next call.
  const MotionDecision& Decide(std::span<const WeightedBehavior> behaviors,
                               const VehicleState& state);
  [[nodiscard]] const MotionDomain& domain() const { return domain_; }
  /// That the behaviors took to bid in the last decision, in real time; 0 without a clock.
  [[nodiscard]] Seconds asked_for() const { return asked_for_; }
  /// The bids that the last decision rests on, in the order of the behaviors.
  [[nodiscard]] std::span<const OwnedMotionBid> bids() const { return {bids_.data(), heard_}; }

 private:
  void Ask(const WeightedBehavior& running, const VehicleState& state);
  void NoteTurn(const std::string& name, std::vector<BehaviorAct>& acts);
  /// What `running` bids goes to `owned`; false if there is nothing to be heard.
  [[nodiscard]] bool Hear(const WeightedBehavior& running, const VehicleState& state,
                          OwnedMotionBid& owned);
  void Fail(const std::string& owner, const std::string& text);
  void NoteUnheard(const OwnedMotionBid& owned);
  void StandAtPoints(MotionBid& bid) const;
  void Add(const OwnedMotionBid& owned);
  void Choose(const VehicleState& state);
  void ChooseTurnRate(bool is_course_joined);
  [[nodiscard]] double Reference(MotionVariable variable, double present) const;

  MotionDomain domain_;
  MotionGridSearch search_;
  AnswerWatch watch_;
  bool is_at_points_;
  MotionDecision decision_;
  std::vector<OwnedMotionBid> bids_;  ///< the first `heard_` are of now; the rest keeps its memory
  std::size_t heard_ = 0;
  std::size_t acted_ = 0;  ///< turns of this decision so far
  Seconds asked_for_;
  std::array<std::vector<WeightedPeak>, 3> peaks_;
  std::vector<WeightedTable> tables_;
};

/// One decision, without an arbiter to keep.
[[nodiscard]] MotionDecision DecideMotion(std::span<const WeightedBehavior> behaviors,
                                          const VehicleState& state, const MotionDomain& domain);

}  // namespace limpet
