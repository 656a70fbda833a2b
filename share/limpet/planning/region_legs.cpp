// SPDX-License-Identifier: MIT
#include "limpet/planning/region_legs.hpp"

#include "limpet/planning/room.hpp"

namespace limpet {

std::optional<std::vector<LegEnd>> LegsInside(const Region& region, const PlanePoint& from,
                                              const PlanePoint& to) {
  if (region.free_space() == nullptr) return std::nullopt;
  const auto places = LegsThrough(*region.free_space(), from, to);
  if (!places) return std::nullopt;
  std::vector<LegEnd> legs;
  for (const PlanePoint& at : *places) {
    legs.push_back({.at_W = at,
                    .allows = [&region](const DubinsPath& path) { return region.Contains(path); },
                    .must_be_passed = false});
  }
  legs.back().must_be_passed = true;
  return legs;
}

}  // namespace limpet
