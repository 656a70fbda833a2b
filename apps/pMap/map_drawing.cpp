// SPDX-License-Identifier: MIT
#include "apps/pMap/map_drawing.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr double kStep = 0.1;  ///< [m] that an object must move, or its sigma change, to be redrawn

/// Along the longer axis of the horizontal ellipse.
double HorizontalSigma(const OpiBelief& belief) {
  const double nn = belief.cov[0], ne = belief.cov[1], ee = belief.cov[3];
  const double mean = 0.5 * (nn + ee);
  return std::sqrt(std::max(0.0, mean + std::hypot(0.5 * (nn - ee), ne)));
}

const char* ColorOf(const std::string& status) {
  if (status == "confirmed") return "green";
  if (status == "new") return "orange";
  if (status == "moved") return "magenta";
  if (status == "removed") return "gray50";
  return "yellow";
}

}  // namespace

MapDrawing::MapDrawing(std::string vehicle, ShapeBoard::Post post)
    : prefix_(vehicle.empty() ? "opi_" : vehicle + "_opi_"), board_(std::move(post)) {}

const MapDrawing::Place& MapDrawing::PlaceOf(const OpiBelief& belief) {
  const double sigma = HorizontalSigma(belief);
  const auto [entry, is_new] =
      places_.try_emplace(belief.id, Place{belief.ned[0], belief.ned[1], sigma});
  Place& drawn = entry->second;
  const double moved = std::hypot(belief.ned[0] - drawn.north, belief.ned[1] - drawn.east);
  if (!is_new && (moved > kStep || std::abs(sigma - drawn.sigma) > kStep)) {
    drawn = {belief.ned[0], belief.ned[1], sigma};
  }
  return drawn;
}

void MapDrawing::Draw(const OpiBeliefs& beliefs) {
  std::vector<Shape> shapes;
  for (const OpiBelief& belief : beliefs.opis) {
    const Place& place = PlaceOf(belief);
    const MapPoint at = MapPointOf(place.north, place.east);
    const std::string label = prefix_ + std::to_string(belief.id);
    const char* color = ColorOf(belief.decided);
    const bool is_removed = belief.decided == "removed";
    shapes.push_back({.label = label,
                      .form = MarkerShape{.at = at,
                                          .width = 0.5,
                                          .type = is_removed ? "square" : "circle",
                                          .primary_color = color},
                      .style = {.msg = fmt::format("{} {}", belief.color, belief.decided),
                                .label_color = color}});
    if (!is_removed) {
      shapes.push_back(
          {.label = label,
           .form = CircleShape{at, place.sigma},
           .style = {.label_color = "invisible", .edge_color = color, .edge_size = 1.0}});
    }
  }
  board_.Replace(prefix_, shapes);
}

}  // namespace limpet
