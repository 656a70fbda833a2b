// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/core/units.hpp"

namespace limpet {

/// Brings the vehicle up when an app is given up that the mission cannot do without, and then ends
/// the mission: thrust stays zero, and a buoyant vehicle rises. Pure: no clock, no mail.
class Surfacing {
 public:
  static constexpr Seconds kLongest{180.0};  ///< MOOS time; for want of a depth
  /// More than any survey's surface_depth_m by default: who ends for want of an app is not to wait
  /// for a vehicle that floats a little deep.
  static constexpr double kSurfaceDepth_m = 0.5;
  /// A vehicle that has just begun to dive is not up because it is not yet down.
  static constexpr Seconds kAtLeast{5.0};

  /// What is known of the vehicle.
  struct Signs {
    bool was_deployed = false;
    std::optional<double> depth_m{};  ///< if it was heard a moment ago
  };
  void Begin(std::string why, Seconds moos_now);
  [[nodiscard]] bool is_under_way() const { return began_ && !has_ended_; }
  [[nodiscard]] bool has_begun() const { return began_.has_value(); }
  [[nodiscard]] bool has_ended() const { return has_ended_; }
  [[nodiscard]] const std::string& why() const { return why_; }
  /// True once: the vehicle is up, or there is no more to wait for; the mission is to be ended.
  [[nodiscard]] bool EndsNow(const Signs& signs, Seconds moos_now);

 private:
  std::string why_;
  std::optional<Seconds> began_;
  bool has_ended_ = false;
};

}  // namespace limpet
