// SPDX-License-Identifier: MIT
// What befell the helm's behaviors, for which they want something else afterwards.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/interval.hpp"

namespace limpet {

struct HelmEvent {
  enum class Kind { kMode, kLife, kWaypoint };
  Kind kind = Kind::kMode;
  double time = 0.0;  ///< as LoggedDecision::time [s]
  std::string who;    ///< the mode variable, or the behavior
  std::string what;   ///< `= ACTIVE:GO`, `began`, `completed`, `on to waypoint 2`
};

/// An entry of a log, or mail.
struct LoggedWord {
  std::string_view variable;
  std::string_view writer;  ///< within the helm: a behavior, or HELM_MODE; else empty
  std::string_view value;
};

/// Gathered from modes, IVPHELM_LIFE_EVENT, WPT_INDEX and WPT_STAT in the order of their writing.
/// A mission may call the last two otherwise: of these nothing is known then.
class HelmEvents {
 public:
  /// Whatever else it is given it leaves alone.
  void Take(const LoggedWord& word, double time);

  [[nodiscard]] const std::vector<HelmEvent>& events() const { return events_; }
  /// Those after the low end of a span of times [s], until its high end.
  [[nodiscard]] std::span<const HelmEvent> Between(const Interval& span) const;

 private:
  void Add(HelmEvent::Kind kind, std::string_view who, std::string what);
  void TakeLife(std::string_view value);

  double last_ = 0.0;  ///< time of the last word
  std::vector<HelmEvent> events_;
};

}  // namespace limpet
