// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "limpet/core/interval.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// A polygon that the vehicle stays in or out of, and how far from its border [m].
struct Fence {
  SimplePolygon polygon;
  double distance = 0.0;
  bool holds_in = false;      ///< the vehicle stays inside; false: outside
  bool reaches_over = false;  ///< of one that holds in: inside or up to `distance` beyond

  /// How far a place is on the allowed side [m]; negative on the other one.
  [[nodiscard]] double Clearance(const PlanePoint& at) const;
  /// No more than that, and found at once: by the box around a zone.
  [[nodiscard]] double ClearanceAtLeast(const PlanePoint& at) const;
};

/// Where the vehicle may be: on the allowed side of every fence. Places are tested exactly, and so
/// are arcs and lines; a raster of clearances answers where the nearest fence is far.
class FreeSpace {
 public:
  /// A border touched exactly, or by a rounding error, is still inside [m].
  static constexpr double kTouch = 1e-6;

  /// REQUIRES: one fence or more.
  explicit FreeSpace(std::vector<Fence> fences);

  /// The least of the fences' clearances [m]: no nearer is any border.
  [[nodiscard]] double Clearance(const PlanePoint& at) const;
  /// The least of the fences' clearances where it is below `enough`, which answers for all above.
  [[nodiscard]] double ClearanceUpTo(const PlanePoint& at, double enough) const;
  /// True if the least of the fences' clearances is at least `least` [m]: exact, though the raster
  /// knows it of most places.
  [[nodiscard]] bool HasClearance(const PlanePoint& at, double least) const;
  [[nodiscard]] bool Contains(const PlanePoint& at) const { return HasClearance(at, -kTouch); }
  /// Exact, not sampled.
  [[nodiscard]] bool Contains(const Pose2& from, const PathSegment& segment) const;

  /// The box around all fences and what they reach over.
  [[nodiscard]] const PlanePoint& low() const { return low_; }
  [[nodiscard]] const PlanePoint& high() const { return high_; }

  /// Clearances on a raster that covers the box, row by row from the south-west.
  struct Raster {
    PlanePoint origin_W;  ///< centre of the first cell
    double cell_m = 0.25;
    int rows = 0, columns = 0;
    std::vector<float> clearance;

    [[nodiscard]] PlanePoint Center(std::size_t cell) const;
    /// The cell that holds a place; nothing outside the raster.
    [[nodiscard]] std::optional<std::size_t> At(const PlanePoint& place) const;
    /// Centres and places of a cell are no farther apart than this [m].
    [[nodiscard]] double slack() const { return 0.7072 * cell_m; }
  };
  [[nodiscard]] const Raster& raster() const { return raster_; }

 private:
  /// The least and the most that its clearance can be.
  struct Bounds {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
  };
  /// Bounds of the clearance at a place, as the raster knows it [m].
  [[nodiscard]] Bounds BoundsAt(const PlanePoint& at) const;
  struct Track;
  [[nodiscard]] bool IsInside(const Track& track, const Interval& piece) const;
  /// Exact: of a piece that may meet a border.
  [[nodiscard]] bool IsInsideBetweenMeetings(const Pose2& from, const PathSegment& piece) const;
  void FillRaster();

  std::vector<Fence> fences_;
  PlanePoint low_, high_;
  Raster raster_;
};

}  // namespace limpet
