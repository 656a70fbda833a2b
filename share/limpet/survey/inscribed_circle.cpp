// SPDX-License-Identifier: MIT
// Squares are halved, the most promising first, until none can hold a place that is deeper inside.
#include "limpet/survey/inscribed_circle.hpp"

#include <algorithm>
#include <numbers>
#include <queue>

namespace limpet {
namespace {

constexpr double kTolerance = 0.02, kTolerance_m = 0.01;

struct Square {
  PlanePoint centre;
  double half = 0.0;  ///< of a side
  double depth = 0.0;
  /// No place of it is deeper.
  [[nodiscard]] double bound() const { return depth + half * std::numbers::sqrt2; }
  [[nodiscard]] bool operator<(const Square& other) const { return bound() < other.bound(); }
};

Square SquareAt(const SimplePolygon& polygon, const PlanePoint& centre, double half) {
  return {.centre = centre, .half = half, .depth = polygon.Depth(centre)};
}

/// Squares as large as the box is narrow, over all of it.
std::priority_queue<Square> SquaresOver(const SimplePolygon& polygon) {
  std::priority_queue<Square> squares;
  const double half = 0.5 * (polygon.high() - polygon.low()).minCoeff();
  for (double north = polygon.low().x(); north < polygon.high().x(); north += 2.0 * half) {
    for (double east = polygon.low().y(); east < polygon.high().y(); east += 2.0 * half) {
      squares.push(SquareAt(polygon, {north + half, east + half}, half));
    }
  }
  return squares;
}

}  // namespace

double InscribedRadius(const SimplePolygon& polygon) {
  std::priority_queue<Square> squares = SquaresOver(polygon);
  double deepest = 0.0;
  while (!squares.empty()) {
    const Square square = squares.top();
    squares.pop();
    deepest = std::max(deepest, square.depth);
    if (square.bound() <= deepest + std::max(kTolerance_m, kTolerance * deepest)) break;
    const double half = 0.5 * square.half;
    for (const double north : {-half, half}) {
      for (const double east : {-half, half}) {
        squares.push(SquareAt(polygon, square.centre + PlanePoint(north, east), half));
      }
    }
  }
  return deepest;
}

}  // namespace limpet
