// SPDX-License-Identifier: MIT
// Symbols that several maps share: each status and purpose has a shape and a colour of its own.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "limpet/core/units.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/objects/status_posterior.hpp"

namespace limpet {

/// confirmed: disc; removed: cross; new: triangle; moved: diamond; uncertain: hollow square;
/// not_inspected: one with a stroke through it.
void DrawStatus(SvgCanvas& canvas, const SvgCanvas::Point& centre, Status status,
                double radius = 7.0);

/// A true object: a ring of its real size.
void DrawTruth(MapAxes& map, const Eigen::Vector3d& p_W, double radius_m);

/// Ellipse of a horizontal covariance (nn, ne, ee) [m^2]; `scale` is pixels per metre times
/// standard deviations.
void DrawCovariance(SvgCanvas& canvas, const SvgCanvas::Point& centre, double scale,
                    const std::array<double, 3>& cov, const Paint& paint);

/// Lines of text beside a place on a map, the first in bold; left of it where it would not fit.
struct PlaceLabel {
  std::vector<std::string> lines;
  double distance = 15.0;  ///< from the place [px]
  std::string_view fill = palette::kMapInk;
};
void DrawLabel(MapAxes& map, const Eigen::Vector3d& p_W, const PlaceLabel& label);

/// Draws where the vehicle started and should end.
void DrawHome(SvgCanvas& canvas, const SvgCanvas::Point& centre);

void DrawTriangle(SvgCanvas& canvas, const SvgCanvas::Point& centre, double radius, Radians turn,
                  const Paint& paint);
void DrawCross(SvgCanvas& canvas, const SvgCanvas::Point& centre, double radius,
               const Paint& paint);

}  // namespace limpet
