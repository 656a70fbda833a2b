// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/expected.hpp"

namespace limpet {

/// A place in the horizontal plane, NED: (north, east) [m].
using PlanePoint = Eigen::Vector2d;

/// A side of a polygon.
struct PlaneEdge {
  PlanePoint from_W, to_W;
  [[nodiscard]] PlanePoint Nearest(const PlanePoint& at) const;
};

/// A polygon that does not cross itself, convex or not, NED.
class SimplePolygon {
 public:
  /// More corners are refused: distances are sums over all of them.
  static constexpr std::size_t kMostCorners = 400;

  /// Corners one after the other, either way round; a last one that repeats the first is left out,
  /// and so are repeated ones. The error says what is wrong, with the places.
  [[nodiscard]] static Expected<SimplePolygon> Of(std::vector<PlanePoint> corners);
  /// REQUIRES: low < high, in both coordinates.
  [[nodiscard]] static SimplePolygon Box(const PlanePoint& low, const PlanePoint& high);

  /// The corners, counter-clockwise with north up and east to the right.
  [[nodiscard]] const std::vector<PlanePoint>& corners() const { return corners_; }
  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] PlaneEdge Edge(std::size_t i) const {
    return {corners_[i], corners_[i + 1 < size() ? i + 1 : 0]};
  }
  [[nodiscard]] bool Contains(const PlanePoint& at) const;
  /// Distance to the border [m]; negative outside.
  [[nodiscard]] double Depth(const PlanePoint& at) const;
  [[nodiscard]] PlanePoint NearestOnBorder(const PlanePoint& at) const;
  /// [m^2]
  [[nodiscard]] double Area() const;
  [[nodiscard]] const PlanePoint& low() const { return low_; }
  [[nodiscard]] const PlanePoint& high() const { return high_; }

 private:
  explicit SimplePolygon(std::vector<PlanePoint> corners);
  std::vector<PlanePoint> corners_;
  PlanePoint low_, high_;  ///< of the box around it
};

/// Where two sides meet, if they do: also where they touch.
[[nodiscard]] std::optional<PlanePoint> Meeting(const PlaneEdge& a, const PlaneEdge& b);

}  // namespace limpet
