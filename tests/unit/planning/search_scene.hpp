// SPDX-License-Identifier: MIT
// What the tests of every search of options share: where they start, over which ground.
#pragma once

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/planning/objective.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet::scene {

inline const Region kSceneRegion(kArea);
inline const Pose2 kStart{-12.5, -15.5, 0.5 * std::numbers::pi};

/// A grid on which a few lanes have been flown, and its ground.
struct HalfSeen {
  HalfSeen() {
    for (const double north : {-13.0, -9.5, -6.0}) {
      Fly(grid, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, 36.0}}));
    }
    ground.Update(grid);
  }
  SurveyGrid grid{kArea};
  Ground ground{grid, TableFootprint()};
};

/// All of the area but its north has been seen.
struct NearlySeen {
  NearlySeen() {
    for (double north = -15.0; north < 11.0; north += 3.0) {
      Fly(grid, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, 36.0}}));
    }
    ground.Update(grid);
  }
  SurveyGrid grid{kArea};
  Ground ground{grid, TableFootprint()};
};

inline Objective Defaults() {
  Objective objective;
  objective.ground = {.cover = 1.0, .frontier = 0.2};
  return objective;
}

inline void ExpectSame(const std::vector<Option>& a, const std::vector<Option>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].estimate, b[i].estimate);
    EXPECT_EQ(a[i].path.end().north, b[i].path.end().north);
    EXPECT_EQ(a[i].path.segments().size(), b[i].path.segments().size());
  }
}

/// Targets on a square grid, 3 m apart.
inline Objective ManyTargets(int rows, int columns) {
  Objective objective;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      objective.targets.push_back({.north = -12.0 + 3.0 * row,
                                   .east = -15.0 + 3.0 * column,
                                   .window = {1.5, 1.5},
                                   .value = 5.0});
    }
  }
  objective.target_decay_m = 1e6;
  return objective;
}

}  // namespace limpet::scene
