// SPDX-License-Identifier: MIT
#include "limpet/mission/fault_schedule.hpp"

#include <algorithm>
#include <set>

#include "limpet/core/require.hpp"

namespace limpet {

FaultSchedule::FaultSchedule(const std::vector<ScenarioFault>& faults) : faults_(faults) {
  for (const ScenarioFault& fault : faults_) {
    Timer timer;
    if (!fault.when.empty()) {
      auto condition = Condition::Parse(fault.when);
      LIMPET_REQUIRE(condition, "a scenario's conditions have been read");
      timer.condition = *condition;
    }
    timers_.push_back(std::move(timer));
  }
}

std::vector<std::string> FaultSchedule::Variables() const {
  std::set<std::string> variables;
  for (const Timer& timer : timers_) {
    if (!timer.condition) continue;
    const std::vector<std::string> read = timer.condition->Variables();
    variables.insert(read.begin(), read.end());
  }
  return {variables.begin(), variables.end()};
}

void FaultSchedule::Update(Seconds now) {
  const auto lookup = [this](std::string_view name) -> const Value* {
    const auto found = heard_.find(name);
    return found == heard_.end() ? nullptr : &found->second;
  };
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    const ScenarioFault& fault = faults_[i];
    Timer& timer = timers_[i];
    if (!timer.origin && (!timer.condition || timer.condition->Holds(lookup, now))) {
      timer.origin = now;
    }
    const bool has_begun = timer.origin && now - *timer.origin >= fault.at;
    timer.is_active = has_begun && (!fault.lasts || now - *timer.origin < fault.at + *fault.lasts);
  }
}

const ScenarioFault* FaultSchedule::Active(std::string_view what) const {
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    if (timers_[i].is_active && faults_[i].what == what) return &faults_[i];
  }
  return nullptr;
}

bool FaultSchedule::Has(std::string_view what) const {
  return std::ranges::any_of(faults_,
                             [what](const ScenarioFault& fault) { return fault.what == what; });
}

}  // namespace limpet
