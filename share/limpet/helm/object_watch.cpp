// SPDX-License-Identifier: MIT
#include "limpet/helm/object_watch.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/topics/grid_place.hpp"

namespace limpet {
namespace {

std::optional<double> SeabedAt(const SurveyGrid& grid, double north, double east) {
  const std::optional<GridPlace> place = GridPlaceOf(grid.frame(), {north, east});
  return place ? grid.Seabed(place->row, place->column) : std::nullopt;
}

}  // namespace

void ObjectWatch::SetBeliefs(const std::vector<OpiBelief>& beliefs) {
  beliefs_ = beliefs;
  ledger_.SetBeliefs(beliefs);
}

std::optional<LookWindow> ObjectWatch::WindowOf(const OpiBelief& belief,
                                                std::optional<double> seabed_down) const {
  if (!model_) {
    return std::nullopt;
  }
  // Where no seabed is known the object is taken to lie on it.
  const double drop = seabed_down ? belief.object.p_W.z() - (*seabed_down - altitude_) : altitude_;
  const double place_sigma =
      std::sqrt(std::max(0.0, 0.5 * (belief.object.cov_W(0, 0) + belief.object.cov_W(1, 1))));
  LookModel model = *model_;
  model.object_radius = belief.object.RadiusOr(model.object_radius);
  return LookWindowAbove(model, {.drop = drop, .slack = allowance_ + place_sigma});
}

std::vector<WatchedObject> ObjectWatch::Objects(const SurveyGrid* grid,
                                                std::optional<double> seabed_down) const {
  std::vector<WatchedObject> objects;
  for (const OpiBelief& belief : beliefs_) {
    const std::optional<double> seen =
        grid != nullptr ? SeabedAt(*grid, belief.object.p_W.x(), belief.object.p_W.y())
                        : std::nullopt;
    objects.push_back({.belief = belief,
                       .window = WindowOf(belief, seen ? seen : seabed_down),
                       .fruitless = ledger_.fruitless(belief.id)});
  }
  return objects;
}

}  // namespace limpet
