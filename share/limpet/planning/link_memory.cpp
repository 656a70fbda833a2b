// SPDX-License-Identifier: MIT
#include "limpet/planning/link_memory.hpp"

#include "limpet/planning/motion_hash.hpp"

namespace limpet {

const PassLink& LinkMemory::Between(const Pose2& from, const Pose2& to) {
  Known& known =
      links_[HashOf({from.north, from.east, from.yaw, to.north, to.east, to.yaw}) % kPlaces];
  if (!known.is_known || !IsSame(known.from, from) || !IsSame(known.to, to)) {
    known = {.from = from,
             .to = to,
             .link = LinkBetween(from, to, *region_, turn_radius_),
             .is_known = true};
  }
  return known.link;
}

}  // namespace limpet
