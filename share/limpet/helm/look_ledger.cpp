// SPDX-License-Identifier: MIT
#include "limpet/helm/look_ledger.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/planning/objective.hpp"

namespace limpet {
namespace {

/// Entropies that differ by less are the same belief [nats].
constexpr double kSameBelief = 0.02;
/// Way after a look until the map has said what it showed [m]: images, detector, map take a second
/// or two.
constexpr double kAnswerWay = 3.0;

}  // namespace

void LookLedger::SetBeliefs(const std::vector<OpiBelief>& beliefs) {
  std::erase_if(entries_, [&beliefs](const auto& entry) {
    return std::ranges::none_of(
        beliefs, [&entry](const OpiBelief& belief) { return belief.id == entry.first; });
  });
  for (const OpiBelief& belief : beliefs) {
    const auto [found, is_new] = entries_.try_emplace(belief.id);
    Entry& entry = found->second;
    const bool is_same = entry.looks == belief.looks &&
                         std::abs(entry.entropy - belief.posterior.Entropy()) < kSameBelief;
    if (is_new || !is_same) {
      entry = {
          .looks = belief.looks, .entropy = belief.posterior.Entropy(), .fruitless = 0, .due = {}};
    }
  }
}

void LookLedger::Promise(const DubinsPath& path, std::span<const WatchedObject> open,
                         double travelled) {
  for (auto& [id, entry] : entries_) {
    if (entry.due && *entry.due <= travelled) {
      continue;  // flown, not yet answered
    }
    const auto object = std::ranges::find_if(
        open, [id = id](const WatchedObject& watched) { return watched.belief.id == id; });
    std::optional<double> first;
    if (object != open.end() && object->window) {
      first = FirstLook(path, {.north = object->belief.object.p_W.x(),
                               .east = object->belief.object.p_W.y(),
                               .window = *object->window});
    }
    // The first promise counts: a look that each new path puts off is never flown either.
    entry.due = first ? std::min(entry.due.value_or(travelled + *first), travelled + *first)
                      : std::optional<double>();
  }
}

bool LookLedger::Judge(double travelled) {
  bool is_any_fruitless = false;
  for (auto& [id, entry] : entries_) {
    if (entry.due && travelled > *entry.due + kAnswerWay) {
      entry.due.reset();
      ++entry.fruitless;
      is_any_fruitless = true;
    }
  }
  return is_any_fruitless;
}

int LookLedger::fruitless(int id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? 0 : found->second.fruitless;
}

}  // namespace limpet
