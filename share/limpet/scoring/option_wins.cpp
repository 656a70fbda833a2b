// SPDX-License-Identifier: MIT
#include "limpet/scoring/option_wins.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

/// Way until the next decision after number `index`, or until nobody flies paths any more.
double WayFlown(const SessionRecord& record, const PoseTrack& track, std::size_t index) {
  if (track.empty()) return 0.0;
  double end = track.time(track.size() - 1);
  if (const auto ascent = record.PhaseStart(SurveyPhase::kAscend))
    end = std::min(end, ascent->value());
  if (index + 1 < record.decisions.size()) {
    end = std::min(end, record.decisions[index + 1].time.value());
  }
  const double begin = record.decisions[index].time.value();
  return std::max(0.0, track.PathAt(end) - track.PathAt(begin));
}

}  // namespace

std::vector<OptionWins> OptionWinsOf(const SessionRecord& record, const PoseTrack& track) {
  std::map<std::string, OptionWins> by_source;
  for (std::size_t i = 0; i < record.decisions.size(); ++i) {
    const auto& offer = record.decisions[i].offer;
    if (!offer || offer->chosen_source.empty()) continue;
    const std::string& source = offer->chosen_source;
    OptionWins& wins = by_source[source];
    wins.source = source;
    ++wins.decisions;
    wins.path_m += WayFlown(record, track, i);
  }
  std::vector<OptionWins> all;
  for (auto& [source, wins] : by_source)
    all.push_back(std::move(wins));
  std::ranges::stable_sort(all, std::ranges::greater(), &OptionWins::path_m);
  return all;
}

}  // namespace limpet
