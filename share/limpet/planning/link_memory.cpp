// SPDX-License-Identifier: MIT
#include "limpet/planning/link_memory.hpp"

#include <bit>
#include <cstdint>

namespace limpet {
namespace {

bool IsSame(const Pose2& a, const Pose2& b) {
  return a.north == b.north && a.east == b.east && a.yaw == b.yaw;
}

std::uint64_t HashOf(const Pose2& from, const Pose2& to) {
  constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15ULL;
  std::uint64_t hash = 0;
  for (const double part : {from.north, from.east, from.yaw, to.north, to.east, to.yaw}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(part)) * kOdd;
    hash ^= hash >> 32U;
  }
  return hash;
}

}  // namespace

const PassLink& LinkMemory::Between(const Pose2& from, const Pose2& to) {
  Known& known = links_[HashOf(from, to) % kPlaces];
  if (!known.is_known || !IsSame(known.from, from) || !IsSame(known.to, to)) {
    known = {.from = from,
             .to = to,
             .link = LinkBetween(from, to, *region_, turn_radius_),
             .is_known = true};
  }
  return known.link;
}

}  // namespace limpet
