// SPDX-License-Identifier: MIT
#include "limpet/planning/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "limpet/core/require.hpp"
#include "limpet/planning/border_meetings.hpp"
#include "limpet/planning/straightness.hpp"

namespace limpet {
namespace {

constexpr double kFinestCell = 0.25;  // [m]
constexpr double kMostRasterCells = 2.5e5;
constexpr double kShortestPiece = 1.0;    // below it dividing costs more than an exact test [m]
constexpr double kRasterRounding = 1e-4;  // [m] of clearances kept as floats

}  // namespace

double Fence::Clearance(const PlanePoint& at) const {
  const double depth = polygon.Depth(at);
  if (!holds_in) return -depth - distance;
  return reaches_over ? depth + distance : depth - distance;
}

/// An arc or a line of no end: places on it cost a sine at most.
struct FreeSpace::Track {
  Pose2 from;
  double curvature;
  PlanePoint along_W;  ///< unit vector of the course at the start
  Track(const Pose2& start, double curved)
      : from(start), curvature(curved), along_W(std::cos(start.yaw), std::sin(start.yaw)) {}

  [[nodiscard]] PlanePoint At(double length) const {
    const PlanePoint start_W(from.north, from.east);
    if (IsStraight(curvature)) return start_W + length * along_W;
    const double half_turn = 0.5 * curvature * length;
    const double sin = std::sin(half_turn), cos = std::cos(half_turn);
    const PlanePoint aside_W(-along_W.y(), along_W.x());
    return start_W + 2.0 * sin / curvature * (cos * along_W + sin * aside_W);
  }
};

PlanePoint FreeSpace::Raster::Center(std::size_t cell) const {
  const auto width = static_cast<std::size_t>(columns);
  return origin_W +
         cell_m * PlanePoint(static_cast<double>(cell / width), static_cast<double>(cell % width));
}

double Fence::ClearanceAtLeast(const PlanePoint& at) const {
  if (holds_in) return -std::numeric_limits<double>::infinity();
  const double to_box = Eigen::AlignedBox2d(polygon.low(), polygon.high()).exteriorDistance(at);
  return to_box > 0.0 ? to_box - distance : -std::numeric_limits<double>::infinity();
}

std::optional<std::size_t> FreeSpace::Raster::At(const PlanePoint& place) const {
  const PlanePoint index = (place - origin_W) / cell_m;
  const double row = index.x() + 0.5, column = index.y() + 0.5;
  // Written so that what is no number is outside; of what is not negative a cast is the floor.
  if (!(row >= 0.0 && row < rows && column >= 0.0 && column < columns)) return std::nullopt;
  return static_cast<std::size_t>(static_cast<std::int64_t>(row) * columns +
                                  static_cast<std::int64_t>(column));
}

FreeSpace::FreeSpace(std::vector<Fence> fences) : fences_(std::move(fences)) {
  LIMPET_REQUIRE(!fences_.empty(), "free space has a border");
  low_ = PlanePoint::Constant(std::numeric_limits<double>::infinity());
  high_ = -low_;
  for (const Fence& fence : fences_) {
    const double over = fence.holds_in && !fence.reaches_over ? 0.0 : fence.distance;
    low_ = low_.cwiseMin(fence.polygon.low() - PlanePoint::Constant(over));
    high_ = high_.cwiseMax(fence.polygon.high() + PlanePoint::Constant(over));
  }
  FillRaster();
}

void FreeSpace::FillRaster() {
  const PlanePoint extent = high_ - low_;
  raster_.cell_m = std::max(kFinestCell, std::sqrt(extent.x() * extent.y() / kMostRasterCells));
  raster_.rows = static_cast<int>(std::ceil(extent.x() / raster_.cell_m)) + 1;
  raster_.columns = static_cast<int>(std::ceil(extent.y() / raster_.cell_m)) + 1;
  raster_.origin_W = low_;
  const std::size_t count =
      static_cast<std::size_t>(raster_.rows) * static_cast<std::size_t>(raster_.columns);
  raster_.clearance.resize(count);
  for (std::size_t cell = 0; cell < count; ++cell) {
    raster_.clearance[cell] = static_cast<float>(Clearance(raster_.Center(cell)));
  }
}

double FreeSpace::Clearance(const PlanePoint& at) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Fence& fence : fences_) {
    if (!(fence.ClearanceAtLeast(at) < least)) continue;
    const double clearance = fence.Clearance(at);
    if (!(clearance >= least)) least = clearance;  // of no place it is no number either
  }
  return least;
}

FreeSpace::Bounds FreeSpace::BoundsAt(const PlanePoint& at) const {
  const auto cell = raster_.At(at);
  if (!cell) return {};
  // Clearances of two places differ by no more than their distance.
  const double there = static_cast<double>(raster_.clearance[*cell]);
  const double slack = raster_.slack() + kRasterRounding;
  return {.low = there - slack, .high = there + slack};
}

double FreeSpace::ClearanceUpTo(const PlanePoint& at, double enough) const {
  const double surely = BoundsAt(at).low;
  return surely >= enough ? surely : Clearance(at);
}

bool FreeSpace::HasClearance(const PlanePoint& at, double least) const {
  const Bounds bounds = BoundsAt(at);
  if (bounds.low >= least) return true;
  return bounds.high >= least && Clearance(at) >= least;
}

bool FreeSpace::IsInside(const Track& track, const Interval& piece) const {
  const double middle = 0.5 * (piece.low + piece.high), half = 0.5 * (piece.high - piece.low);
  const PlanePoint at = track.At(middle);
  const Bounds bounds = BoundsAt(at);
  if (bounds.low >= half) return true;
  if (bounds.high < -kTouch) return false;
  if (2.0 * half > kShortestPiece) {
    return IsInside(track, {piece.low, middle}) && IsInside(track, {middle, piece.high});
  }
  if (HasClearance(at, half)) return true;
  return IsInsideBetweenMeetings(Advance(track.from, {track.curvature, piece.low}),
                                 {.curvature = track.curvature, .length = 2.0 * half});
}

bool FreeSpace::IsInsideBetweenMeetings(const Pose2& from, const PathSegment& piece) const {
  const double half = 0.5 * piece.length;
  const Pose2 middle = Advance(from, {.curvature = piece.curvature, .length = half});
  // Between two meetings with a border it is on one side of all of them.
  std::vector<double> cuts{0.0, piece.length};
  for (const Fence& fence : fences_) {
    const PlanePoint at(middle.north, middle.east);
    const bool is_far = fence.ClearanceAtLeast(at) > half || fence.Clearance(at) > half + kTouch;
    if (is_far) continue;
    AddMeetings({.from = from, .segment = piece}, fence.polygon, fence.distance, cuts);
  }
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Pose2 between =
        Advance(from, {.curvature = piece.curvature, .length = 0.5 * (cuts[i] + cuts[i + 1])});
    if (cuts[i + 1] - cuts[i] > kTouch && !Contains({between.north, between.east})) return false;
  }
  return true;
}

bool FreeSpace::Contains(const Pose2& from, const PathSegment& segment) const {
  const Pose2 end = Advance(from, segment);
  return Contains({from.north, from.east}) && Contains({end.north, end.east}) &&
         IsInside(Track(from, segment.curvature), {0.0, segment.length});
}

}  // namespace limpet
