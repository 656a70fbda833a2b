// SPDX-License-Identifier: MIT
#include "limpet/scoring/pictured_object.hpp"

#include <algorithm>

namespace limpet {
namespace {

std::string TruthOf(int id, const OpiScores& scores) {
  const auto found =
      std::ranges::find(scores.found, id, [](const OpiScore& score) { return score.belief.id; });
  if (found != scores.found.end()) return found->truth;
  const auto invented = std::ranges::find(scores.invented, id, &OpiBelief::id);
  return invented != scores.invented.end() ? "nothing" : "";
}

}  // namespace

std::vector<PicturedObject> PicturedObjects(const SessionRecord& record, const OpiScores& scores) {
  std::vector<PicturedObject> objects;
  for (const OpiBelief& opi : record.opis) {
    const std::vector<ObjectChip>& chips = record.chips.Of(opi.landmark);
    if (chips.empty()) continue;
    objects.push_back({.id = opi.id,
                       .color = opi.object.color,
                       .decided = opi.decided,
                       .truth = TruthOf(opi.id, scores),
                       .chips = chips});
  }
  return objects;
}

}  // namespace limpet
