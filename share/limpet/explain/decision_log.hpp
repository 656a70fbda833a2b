// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
};

/// The decisions of one vehicle, gathered from its mail in the order in which it was written.
class DecisionLog {
 public:
  /// True for the variables that Take reads.
  [[nodiscard]] static bool Listens(std::string_view variable);
  /// What is no decision, though it bears the name of one, is counted.
  void Take(std::string_view variable, std::string_view value, double time);

  [[nodiscard]] const std::vector<LoggedDecision>& decisions() const { return decisions_; }
  /// Once a second or so.
  [[nodiscard]] const std::vector<LoggedMotion>& motions() const { return motions_; }
  [[nodiscard]] std::size_t unreadable() const { return unreadable_; }
  /// The one in force at a time: the last made until then. Null before the first.
  [[nodiscard]] const LoggedDecision* InForceAt(double time) const;
  /// How it moved at a time, by the last word until then. Null before the first; older logs say
  /// nothing of it.
  [[nodiscard]] const LoggedMotion* MotionAt(double time) const;

 private:
  std::vector<LoggedDecision> decisions_;
  std::vector<LoggedMotion> motions_;
  std::size_t unreadable_ = 0;
};

}  // namespace limpet
