// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <string>

#include "limpet/helm/generator_registry.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {

/// Half of Table 1's area has been seen; the vehicle is somewhere.
class HalfSurveyed {
 public:
  explicit HalfSurveyed(const Pose2& at) {
    for (const double north : {-13.0, -9.5, -6.0}) {
      scene::Fly(grid_, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, 36.0}}));
    }
    ground_.Update(grid_);
    now.pose = at;
    now.ground = &ground_;
    now.region = &region_;
    now.turn_radius = scene::kRadius;
    goals.objective.ground = {.cover = 1.0, .frontier = 0.5};
    goals.objective.targets = {{.north = 4.0, .east = 1.0, .window = {1.5, 1.5}, .value = 40.0},
                               {.north = -6.0, .east = -5.0, .window = {1.5, 1.5}, .value = 40.0}};
    goals.destinations = {{.north = 0.0, .east = 0.0}};
    goals.leads_into_region = true;
  }
  /// What the generator called `name` offers after `options`.
  [[nodiscard]] std::vector<Option> OffersOf(const std::string& name,
                                             std::vector<Option> options = {}) const {
    const std::size_t before = options.size();
    GeneratorParams().Build(name, Random(3)).front()->Offer(now, goals, options);
    options.erase(options.begin(), options.begin() + static_cast<std::ptrdiff_t>(before));
    return options;
  }
  [[nodiscard]] const Region& region() const { return region_; }

  Situation now;
  SearchGoals goals;

 private:
  SurveyGrid grid_{scene::kArea};
  Ground ground_{grid_, scene::TableFootprint()};
  Region region_{scene::kArea};
};

/// Somewhere in it.
inline const Pose2 kInside{-12.5, -15.5, 0.5 * std::numbers::pi};

}  // namespace limpet
