// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/explain/helm_event.hpp"
#include "limpet/explain/helm_stop.hpp"
#include "limpet/explain/waiting_behavior.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// A decision of the helm and when it was made.
struct LoggedDecision {
  double time = 0.0;  ///< since the start of the log, or MOOS time of a live community [s]
  HelmBids bids;
};

/// How the helm moved, and when.
struct LoggedMotion {
  double time = 0.0;  ///< as LoggedDecision has it [s]
  HelmMotion motion;
  std::optional<std::string> stopped;  ///< why it drove nothing from then on; nothing: it drove
};

/// The decisions of one vehicle, gathered from its mail in the order in which it was written.
class DecisionLog {
 public:
  /// How much later than its HELM_MOTION an iteration of the helm may say what else came of it, and
  /// whether it stopped [s].
  static constexpr double kIteration = 0.05;

  /// What is no decision, though it bears the name of one, is counted.
  void Take(const LoggedWord& word, double time);
  void Take(std::string_view variable, std::string_view value, double time) {
    Take({.variable = variable, .writer = {}, .value = value}, time);
  }

  [[nodiscard]] const std::vector<LoggedDecision>& decisions() const { return decisions_; }
  /// Once a second or so.
  [[nodiscard]] const std::vector<LoggedMotion>& motions() const { return motions_; }
  [[nodiscard]] std::size_t unreadable() const { return unreadable_; }
  /// The one in force at a time: the last made until then. Null before the first.
  [[nodiscard]] const LoggedDecision* InForceAt(double time) const;
  /// How it moved at a time, by the last word until then, or that it was stopped. Nothing before
  /// the first; older logs say nothing of it.
  [[nodiscard]] std::optional<LoggedMotion> MotionAt(double time) const;
  [[nodiscard]] const std::vector<HelmStop>& stops() const { return stops_.stops(); }
  /// As of a stop's begin; with what behaviors wanted then, if the helm said.
  [[nodiscard]] LoggedMotion MotionIn(const HelmStop& stop) const;
  /// The first word on how it moved after a stop; without any, that nobody says.
  [[nodiscard]] LoggedMotion MotionAfter(const HelmStop& stop) const;
  [[nodiscard]] const HelmEvents& events() const { return events_; }
  /// Which behaviors did not run at a time, and for want of what.
  [[nodiscard]] std::vector<WaitingBehavior> WaitingAt(double time) const {
    return waiting_.At(time);
  }

 private:
  std::vector<LoggedDecision> decisions_;
  std::vector<LoggedMotion> motions_;
  HelmStops stops_;
  HelmEvents events_;
  WaitingBehaviors waiting_;
  std::size_t unreadable_ = 0;
};

}  // namespace limpet
