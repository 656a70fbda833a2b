// SPDX-License-Identifier: MIT
#include "limpet/scoring/phase_times.hpp"

#include <algorithm>

namespace limpet {

std::vector<PhaseTime> TimesOfPhases(const SessionRecord& record, Seconds end) {
  std::vector<PhaseTime> times;
  const auto& phases = record.phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const std::string& name = phases[i].value;
    if (name == "IDLE") continue;
    const Seconds until = i + 1 < phases.size() ? phases[i + 1].time : end;
    auto known = std::ranges::find(times, name, &PhaseTime::phase);
    if (known == times.end()) known = times.insert(times.end(), PhaseTime{.phase = name});
    known->seconds += std::max((until - phases[i].time).value(), 0.0);
  }
  return times;
}

}  // namespace limpet
