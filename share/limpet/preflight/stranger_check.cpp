// SPDX-License-Identifier: MIT
// Behaviors that are not ours, by their names.
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/helm/behavior_names.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

/// The known behavior that a name is a slip of; "" of a stock one's and of a stranger's.
std::string MeantBy(const std::string& name, const std::vector<std::string>& known) {
  const auto& stock = StockBehaviors();
  return std::ranges::find(stock, name) != stock.end() ? "" : SlipOf(name, known);
}

}  // namespace

void SetStrangersAside(BehaviorFile& file, BehaviorReader reader, MissionProblems& found) {
  std::vector<std::string> known;
  std::ranges::transform(BehaviorRegistry(), std::back_inserter(known),
                         [](const auto& registered) { return registered.first; });
  std::erase_if(file.behaviors, [&](const ConfigBlock& block) {
    if (BehaviorRegistry().contains(block.name)) return false;
    const std::string meant = MeantBy(block.name, known);
    const bool is_meant_so =
        meant.empty() || reader == BehaviorReader::kOthers ||
        (reader == BehaviorReader::kUnknown && IsVariantOfBehavior(block.name, meant));
    const std::string nearest =
        NearestBehaviorText(block.name) + "; `limpet describe` lists those there are";
    if (is_meant_so && MisnamedBehavior(block.name).empty()) {
      found.notes.push_back({block.where, block.name,
                             fmt::format("is no behavior of Limpet's: not checked; {}", nearest)});
    } else {
      found.syntax.push_back(
          {block.where, "Behavior", fmt::format("no behavior `{}`; {}", block.name, nearest)});
    }
    return true;
  });
}

}  // namespace limpet::internal
