// SPDX-License-Identifier: MIT
// A behavior bids on where to go next (options, in metres of path) and on how to move now (course,
// speed, depth).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/helm/behavior_act.hpp"
#include "limpet/helm/motion_table.hpp"
#include "limpet/helm/peak.hpp"
#include "limpet/helm/situation.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/topics/bid.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {

/// A warning that a behavior declares and asks the helm to raise.
struct BehaviorWarning {
  WarningId id;
  std::string text;
};

/// How now: preferences over course [rad], speed [m/s] and depth [m]; absent means no opinion. They
/// add up: each peak is worth up to its share of the behavior's weight, the table up to all of it.
struct MotionBid {
  std::optional<Peak> course;
  std::optional<Peak> speed;
  std::optional<Peak> depth;
  /// Added to `course`: a say for the present one, so that two ways as good do not take turns.
  std::optional<Peak> present_course{};
  /// For what no peak can say, e.g. courses that are bad at one speed and good at another. The
  /// behavior's own, made in `Start` over `state.domain`; unchanged until its next `Move`.
  const MotionTable* table = nullptr;
  std::optional<double> turn_rate;  ///< feed-forward of the course [rad/s], starboard positive
  std::optional<BehaviorWarning> warning;
  std::vector<BehaviorAct> acts{};  ///< what it posts, and that it is done; in this order
};

/// A function of parameters and a snapshot: no look-ups by name, no clock, no side effects. A
/// behavior may bid on either decision or on both. Its run state (conditions, flags, pwt, updates)
/// is the host's business.
class Behavior {
 public:
  virtual ~Behavior() = default;

  /// The behavior's name as its block calls it; set by who makes it from a block.
  [[nodiscard]] const std::string& name() const { return name_; }
  void SetName(std::string name) { name_ = std::move(name); }

  /// Variables that it reads by `VehicleState::Heard`, besides those of the state.
  [[nodiscard]] virtual std::vector<std::string> Variables() const { return {}; }
  /// Called once on the behavior of a template (`templating = spawn` or `clone`): what it posts as
  /// the helm begins, to whom it is that sends the `updates` by which behaviors are made of it.
  [[nodiscard]] virtual std::optional<BehaviorPost> Request(const std::string& updates) const {
    static_cast<void>(updates);
    return std::nullopt;
  }
  /// The text of a macro of its own in flags, e.g. NX of `$[NX]`; nothing if it has none such.
  [[nodiscard]] virtual std::optional<std::string> Macro(std::string_view name,
                                                         const VehicleState& state) const {
    static_cast<void>(name), static_cast<void>(state);
    return std::nullopt;
  }
  /// Called on one that an update has made of `former`, of the same class: takes over how far that
  /// had come, as far as the keys that the update names allow. False: it starts anew.
  [[nodiscard]] virtual bool TakeOver(const Behavior& former,
                                      const std::vector<std::string>& keys) {
    static_cast<void>(former), static_cast<void>(keys);
    return false;
  }

  /// True if its own parameters say that it lives on after it has completed.
  [[nodiscard]] virtual bool IsPerpetual() const { return false; }
  /// Called when mail has wound its `duration` up.
  virtual void Restart() {}
  /// Called each time that it completes, after its end flags.
  virtual void Complete(const VehicleState& state) { static_cast<void>(state); }

  /// Called when the behavior begins to run, at first and after each idle spell.
  virtual void Start(const VehicleState& state) { static_cast<void>(state); }
  /// Called when it ceases to run, also for good: e.g. erases what it has drawn.
  [[nodiscard]] virtual std::vector<BehaviorAct> Stop(const VehicleState& state) {
    static_cast<void>(state);
    return {};
  }
  /// Called every helm tick while it does not run.
  [[nodiscard]] virtual std::vector<BehaviorAct> Idle(const VehicleState& state) {
    static_cast<void>(state);
    return {};
  }

  /// How now; called every helm tick while running.
  [[nodiscard]] virtual MotionBid Move(const VehicleState& state) {
    static_cast<void>(state);
    return {};
  }

  /// True if it says only what must not be, e.g. keeps off an obstacle: with `goals_mandatory` the
  /// helm stands still where nobody else bids.
  [[nodiscard]] virtual bool IsConstraint() const { return false; }

  /// True if it bids for looks at objects: left out when a survey is to weigh coverage alone.
  [[nodiscard]] virtual bool IsAboutObjects() const { return false; }
  /// What it wants of each object now; nothing from behaviors that are not about objects.
  [[nodiscard]] virtual std::vector<RevisitInterest> Interests(const Situation& now) const {
    static_cast<void>(now);
    return {};
  }
  /// True if a view decision is wanted while this behavior runs.
  [[nodiscard]] virtual bool WantsView() const { return false; }
  /// Adds this behavior's wishes, times `weight`, to what generators look for: rates of new ground,
  /// targets, destinations, or a term of its own (`goals.objective.terms`), so that searches find
  /// what `Value` will like.
  virtual void Shape(const Situation& now, double weight, SearchGoals& goals) const {
    static_cast<void>(now), static_cast<void>(weight), static_cast<void>(goals);
  }
  /// Appends paths of its own; `options` holds those of the generators and of behaviors before it.
  virtual void Offer(const Situation& now, std::vector<Option>& options) const {
    static_cast<void>(now), static_cast<void>(options);
  }
  /// Values any option; nothing means no opinion.
  [[nodiscard]] virtual std::optional<Bid> Value(const Prospect& prospect,
                                                 const Situation& now) const {
    static_cast<void>(prospect), static_cast<void>(now);
    return std::nullopt;
  }

 private:
  std::string name_;
};

}  // namespace limpet
