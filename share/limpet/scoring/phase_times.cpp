// SPDX-License-Identifier: MIT
#include "limpet/scoring/phase_times.hpp"

#include <algorithm>

#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

/// How much of the time between the two [s] SURFACE_FIX was true.
double TimeUp(const SessionRecord& record, Seconds from, Seconds until) {
  double up = 0.0;
  const auto& fixes = record.surface_fixes;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    if (!fixes[i].value) continue;
    const Seconds end = i + 1 < fixes.size() ? std::min(fixes[i + 1].time, until) : until;
    up += std::max((end - std::max(fixes[i].time, from)).value(), 0.0);
  }
  return up;
}

void Add(const std::string& phase, double seconds, std::vector<PhaseTime>& times) {
  auto known = std::ranges::find(times, phase, &PhaseTime::phase);
  if (known == times.end()) known = times.insert(times.end(), PhaseTime{.phase = phase});
  known->seconds += seconds;
}

}  // namespace

std::vector<PhaseTime> TimesOfPhases(const SessionRecord& record, Seconds end) {
  std::vector<PhaseTime> times;
  const auto& phases = record.phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const std::string& name = phases[i].value;
    if (name == NameOf(SurveyPhase::kIdle)) continue;
    const Seconds from = phases[i].time;
    const Seconds until = std::max(i + 1 < phases.size() ? phases[i + 1].time : end, from);
    const double up = name == NameOf(SurveyPhase::kSurvey) ? TimeUp(record, from, until) : 0.0;
    Add(name, (until - from).value() - up, times);
    if (up > 0.0) Add(kSurfaceFixPhase, up, times);
  }
  return times;
}

}  // namespace limpet
