// SPDX-License-Identifier: MIT
#include "apps/pMap/map_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "limpet/objects/status_color.hpp"

namespace limpet {
namespace {

constexpr double kStep = 0.1;  ///< [m] that an object must move, or its sigma change, to be redrawn

/// 1-sigma of an object's place along the longer axis of its horizontal ellipse [m].
double HorizontalSigma(const OpiBelief& belief) {
  const Eigen::Matrix3d& S = belief.object.cov_W;
  const double nn = S(0, 0), ne = S(0, 1), ee = S(1, 1);
  const double mean = 0.5 * (nn + ee);
  return std::sqrt(std::max(0.0, mean + std::hypot(0.5 * (nn - ee), ne)));
}

constexpr std::string_view kUndecided = "yellow";

}  // namespace

MapDrawing::MapDrawing(const std::string& vehicle, ShapeBoard::Post post)
    : prefix_(vehicle.empty() ? "opi_" : vehicle + "_opi_"), board_(std::move(post)) {}

const MapDrawing::Place& MapDrawing::PlaceOf(const OpiBelief& belief) {
  const double sigma = HorizontalSigma(belief);
  const double north = belief.object.p_W.x(), east = belief.object.p_W.y();
  const auto [entry, is_new] = places_.try_emplace(belief.id, Place{north, east, sigma});
  Place& drawn = entry->second;
  const double moved = std::hypot(north - drawn.north, east - drawn.east);
  if (!is_new && (moved > kStep || std::abs(sigma - drawn.sigma) > kStep)) {
    drawn = {north, east, sigma};
  }
  return drawn;
}

void MapDrawing::Draw(const OpiBeliefs& beliefs) {
  std::vector<Shape> shapes;
  for (const OpiBelief& belief : beliefs.opis) {
    const Place& place = PlaceOf(belief);
    const MapPoint at = MapPointOf({place.north, place.east});
    const std::string label = prefix_ + std::to_string(belief.id);
    const std::optional<StatusColor> decided = ColorOf(belief.decided);
    const std::string color(decided ? decided->moos : kUndecided);
    const bool is_removed = belief.decided == Status::kRemoved;
    shapes.push_back(
        {.label = label,
         .form = MarkerShape{.at = at,
                             .width = 0.5,
                             .type = is_removed ? "square" : "circle",
                             .primary_color = color},
         .style = {.msg = fmt::format("{} {}", belief.object.color, NameOf(belief.decided)),
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
