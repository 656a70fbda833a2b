// SPDX-License-Identifier: MIT
// What differs between the maps of two sessions.
#pragma once

#include <vector>

#include "estimation/matching/frame_offset.hpp"
#include "limpet/map_files/depth_grid.hpp"

namespace limpet {

/// Columns side by side whose depth differs the same way and significantly.
struct DepthChange {
  double north = 0.0, east = 0.0;  ///< middle, in B's frame [m]
  double area_m2 = 0.0;
  double mean_m = 0.0;  ///< B's depth less A's, positive: deeper
  double z = 0.0;       ///< greatest number of sigmas of a column in it, signed as mean_m
};

/// Depth of session B less that of session A, where both know it.
struct DepthDifference {
  std::size_t cells = 0;                 ///< compared
  std::size_t cells_a = 0, cells_b = 0;  ///< of each that are known
  std::size_t significant_cells = 0;     ///< of them off by more than kSignificant sigmas
  double offset_m = 0.0;     ///< what all differ by: tide, sensor's zero; taken off before the rest
  double offset_sd_m = 0.0;  ///< its standard deviation
  double rms_m = 0.0;        ///< of what is left
  /// By what the sigmas of both depths are multiplied, 1 or more: so that most of the ground
  /// differs as they say. What they do not hold (places off by decimetres on rough or sloping
  /// ground) is in it; it takes for granted that half of the ground or more has not changed.
  double sigma_scale = 1.0;
  std::vector<DepthChange> changes;  ///< largest volume first

  static constexpr double kSignificant = 3.0;
};

/// `offset` is A's frame in B's.
[[nodiscard]] DepthDifference Difference(const DepthGrid& a, const DepthGrid& b,
                                         const FrameOffset& offset);

}  // namespace limpet
