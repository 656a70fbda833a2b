// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/pass.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// The motions that joined passes before: tours that are compared differ in a pass or two, and
/// around obstacles to find the motion between two poses takes longer than all else. Of what falls
/// into the same place the newest stays, so that its size does not grow.
class LinkMemory {
 public:
  /// `region` must outlive this.
  LinkMemory(const Region& region, Meters turn_radius)
      : region_(&region), turn_radius_(turn_radius), links_(kPlaces) {}

  /// The link as LinkBetween finds it. Good until the next call.
  [[nodiscard]] const PassLink& Between(const Pose2& from, const Pose2& to);

 private:
  static constexpr std::size_t kPlaces = 2048;
  struct Known {
    Pose2 from, to;
    PassLink link;
    bool is_known = false;
  };
  const Region* region_;
  Meters turn_radius_;
  std::vector<Known> links_;
};

}  // namespace limpet
