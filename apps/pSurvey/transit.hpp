// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "limpet/planning/region.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// The way from where the vehicle dived to the area, if that is outside: over once the area or its
/// margin is reached.
class Transit {
 public:
  /// True if the vehicle has come nearer to the area since the last time, or reached it; by the
  /// mission's transit, if there is one, which may lead away from the area first.
  bool Track(const NavState& nav, const Region& region);
  [[nodiscard]] bool is_over() const { return to_go_m_ <= 0.0; }
  [[nodiscard]] bool is_under_way() const { return !is_over() && std::isfinite(to_go_m_); }
  /// The least way to the area and its margin so far [m]; infinite before the first Track.
  [[nodiscard]] double to_go_m() const { return to_go_m_; }

 private:
  [[nodiscard]] double WayLeft(const PlanePoint& here) const;

  std::optional<std::vector<PlanePoint>>
      places_;  ///< of the mission's transit, from the first Track
  double to_go_m_ = std::numeric_limits<double>::infinity();
};

}  // namespace limpet
