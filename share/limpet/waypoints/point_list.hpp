// SPDX-License-Identifier: MIT
// Lists of points as behavior files write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/shapes/shape.hpp"

namespace limpet {

/// Reads `60,-40 : 60,-160`, also with `label,a` and the like between them, `pts={60,-40:60,-160}`,
/// `x=60,y=-40`, and the figures of figure_points.hpp. A third coordinate of a point is left out.
/// Nothing if the text is none of these, or has a second `pts=` of which it would have to be lost.
[[nodiscard]] std::optional<std::vector<MapPoint>> ParsePoints(std::string_view text);

/// What stands before or behind the `pts={...}` of a text and does not say how it is drawn
/// (`label=pier`): nobody would read it. Empty if nothing does, or there is no `pts={`.
[[nodiscard]] std::string BesidePoints(std::string_view text);

/// One point: `60,-40` or `x=60,y=-40`.
[[nodiscard]] std::optional<MapPoint> ParsePoint(std::string_view text);

/// `60,-40:60,-160`, to 0.01 m.
[[nodiscard]] std::string PointsText(const std::vector<MapPoint>& points);

/// The points in the order in which a vehicle at `start` comes past them that always goes to the
/// nearest one left.
[[nodiscard]] std::vector<MapPoint> GreedyTour(std::vector<MapPoint> points, MapPoint start);

}  // namespace limpet
