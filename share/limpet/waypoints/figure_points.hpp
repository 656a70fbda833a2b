// SPDX-License-Identifier: MIT
// Figures that behavior files name by their measures, as points.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "limpet/shapes/shape.hpp"

namespace limpet {

/// Corners of a figure, as MOOS-IvP lays them, in metres and compass degrees but where said:
///   format=lawnmower, x=, y=, height=, width=, lane_width= (or swath=), degs=, rows=east-west or
///     north-south, startx=, starty=: from the corner that is nearest to the start, else the datum;
///   format=bowtie, x=, y=, height=, wid1=, wid2=, wid3=, startx=, starty=;
///   zigzag:x, y, angle, length, period, amplitude;
///   format=radial, x=, y=, radius=, pts=, or radial:x, y, radius, pts;
///   format=ellipse, x=, y=, major=, minor=, pts=, degs= or rads= (from east to north);
///   format=oval, x=, y=, rad=, len=, ang=;
///   format=wedge, x=, y=, lang=, rang=, range=, pts=;
///   format=pylon, x1=, y1=, x2=, y2=, axis_pad=, perp_pad=.
/// `kind:` or `kind::` in front stands for `format=kind`; `snap=` rounds. A place alone, `x=, y=`,
/// is one point. Nothing if the text is none of these, or would be more than 10,000 points.
[[nodiscard]] std::optional<std::vector<MapPoint>> FigurePoints(std::string_view text);

}  // namespace limpet
