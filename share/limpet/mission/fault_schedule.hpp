// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/mission/condition.hpp"
#include "limpet/mission/fault_kinds.hpp"

namespace limpet {

/// Which faults of a scenario are so now: a function of time and of the variables that their
/// conditions read, so that equal runs fail alike.
class FaultSchedule {
 public:
  FaultSchedule() = default;
  /// REQUIRES: conditions that parse, as those of a scenario do.
  explicit FaultSchedule(const std::vector<ScenarioFault>& faults);

  /// What its conditions read; to be heard.
  [[nodiscard]] std::vector<std::string> Variables() const;
  void Hear(const std::string& variable, const Value& value) { heard_[variable] = value; }
  /// `now` does not go back; the first is the start of the session.
  void Update(Seconds now);
  /// One that is so now; null if none of that kind is.
  [[nodiscard]] const ScenarioFault* Active(std::string_view what) const;
  /// Any of that kind, now or ever.
  [[nodiscard]] bool Has(std::string_view what) const;
  [[nodiscard]] const std::vector<ScenarioFault>& faults() const { return faults_; }
  /// Whether the fault with this index in faults() is active.
  [[nodiscard]] bool IsActive(std::size_t index) const { return timers_[index].is_active; }

 private:
  struct Timer {
    std::optional<Condition> condition;
    std::optional<Seconds> origin;  ///< when its time began to count
    bool is_active = false;
  };
  std::vector<ScenarioFault> faults_;
  std::vector<Timer> timers_;
  std::map<std::string, Value, std::less<>> heard_;
};

}  // namespace limpet
