// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/message.hpp"

namespace limpet {

/// How long a behavior may live; `duration` and its kin.
struct DurationSettings {
  std::optional<Seconds> limit{};  ///< absent: for ever
  std::string status_variable{};   ///< where the seconds left are posted; empty: nowhere
  std::string reset_variable{};    ///< mail that winds it up again; empty: none
  std::string reset_value{};       ///< only mail of this value; empty: any
  bool counts_idle_time = true;    ///< once it has begun to run
};

/// A behavior's clock: begins when its conditions first hold, and counts how long it has run and
/// been idle.
class DurationClock {
 public:
  explicit DurationClock(DurationSettings settings = {}) : settings_(std::move(settings)) {}

  void SetSettings(DurationSettings settings) { settings_ = std::move(settings); }
  [[nodiscard]] const DurationSettings& settings() const { return settings_; }

  /// True if mail of this name and value winds the clock up.
  [[nodiscard]] bool IsResetBy(std::string_view variable, const Value& value) const;
  void Reset();
  /// Called while the conditions hold; begins the count if it has not begun.
  void Begin(Seconds now);
  /// Seconds left; nothing without a limit.
  [[nodiscard]] std::optional<Seconds> Remaining(Seconds now) const;
  /// The time since the last call was spent running or idle.
  void Spend(Seconds now, bool is_running);

  [[nodiscard]] Seconds running() const { return running_; }
  [[nodiscard]] Seconds idle() const { return idle_; }

 private:
  DurationSettings settings_;
  std::optional<Seconds> begun_;  ///< when the conditions first held
  std::optional<Seconds> spent_;  ///< when time was last accounted for
  Seconds running_{0.0}, idle_{0.0};
};

}  // namespace limpet
