// SPDX-License-Identifier: MIT
// Ground that a survey did not show, and why.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include <Eigen/Core>

#include "limpet/scoring/report_settings.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// A place of the area at which an object would not have been seen well.
struct UnseenPlace {
  Eigen::Vector2d at_W = Eigen::Vector2d::Zero();  ///< north, east
  double height_m = 0.0;                           ///< of the object's centre above the seabed
  bool was_seen = false;                           ///< well, but in too few frames
  bool was_hidden = false;                         ///< in an image, behind an obstacle
};

/// Why such a place was not seen. Of several reasons the first that holds.
enum class WhyUnseen {
  kZone,         ///< it could be seen were it not for the keep-out zones
  kClearance,    ///< nowhere in the operating region would the image show it
  kTurn,         ///< it is within reach only of where the region is narrower than a turn
  kTooFewLooks,  ///< it was in the image, in one or two frames
  kNotReached,   ///< it could have been seen, and no path went there
  kObstacle,     ///< an obstacle stands on it, or before it in every image
};
inline constexpr std::size_t kWaysUnseen = 6;
/// "zone", "clearance", "turn", "too_few_looks", "not_reached", "obstacle".
[[nodiscard]] const char* NameOf(WhyUnseen why);

/// Shares of the area, 0 to 1; with the ground that obstacles stand on, which is not to be seen.
struct UnseenScore {
  double bottom = 0.0;  ///< of the seabed
  double band = 0.0;    ///< of the places of objects
  std::array<double, kWaysUnseen> band_by_reason{};

  /// The reason that holds for most of the band's share; zones if there is none.
  [[nodiscard]] WhyUnseen main_reason() const;
};

/// Counts what kept places from being seen. Where the vehicle may be is told by the area's shape
/// and the turning radius, as `limpet check` reckons it.
class UnseenCounter {
 public:
  UnseenCounter(const SurveyArea& area, const ReportSettings& settings);
  ~UnseenCounter();
  UnseenCounter(const UnseenCounter&) = delete;
  UnseenCounter& operator=(const UnseenCounter&) = delete;

  void Add(const UnseenPlace& place);
  [[nodiscard]] std::size_t Of(WhyUnseen why) const {
    return counts_[static_cast<std::size_t>(why)];
  }

 private:
  struct Reachable;
  [[nodiscard]] WhyUnseen WhyOf(const UnseenPlace& place) const;

  double altitude_, half_across_, turning_radius_;
  /// Null: the area is none, or has no zones.
  std::unique_ptr<const Reachable> with_zones_, without_zones_;
  std::array<std::size_t, kWaysUnseen> counts_{};
};

}  // namespace limpet
