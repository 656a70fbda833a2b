// SPDX-License-Identifier: MIT
// What a tour of the whole survey costs.
#include "limpet/planning/survey_tour.hpp"

#include <cstddef>

#include <gtest/gtest.h>

#include "limpet/planning/lane_tours.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

/// Tours of the first passes of the best lanes, which end before most has been seen.
class TourThatEnds : public ::testing::Test {
 protected:
  [[nodiscard]] TourCost Cost(std::size_t passes) {
    judge_.Reset(DubinsPath(scene::kStart), goal_);
    if (lanes_.empty()) lanes_ = LaneTours(judge_, {}).front();
    return judge_.Cost({lanes_.begin(), lanes_.begin() + static_cast<std::ptrdiff_t>(passes)});
  }
  TourGoal goal_;
  SurveyGrid grid_{scene::kArea};
  Ground ground_{grid_, scene::TableFootprint()};
  TourJudge judge_{ground_, scene::kSceneRegion, scene::kRadius};
  SurveyTour lanes_;
};

TEST_F(TourThatEnds, CostsMoreThanOneThatGoesOnHoweverSoonMostIsToBeSeen) {
  for (const double weight : {0.0, 5.0, 20.0, 100.0}) {
    goal_.most_weight = weight;
    const double none = Cost(0).total, one = Cost(1).total, three = Cost(3).total;
    EXPECT_LT(one, none) << "most_weight " << weight;
    EXPECT_LT(three, one) << "most_weight " << weight;
  }
}

TEST_F(TourThatEnds, IsFarFromMostBeingSeenByWhatItHasNotShown) {
  EXPECT_GT(Cost(0).most, Cost(1).most);
  EXPECT_GT(Cost(1).most, Cost(3).most);
  EXPECT_LT(Cost(lanes_.size()).most, Cost(lanes_.size()).length);
}

}  // namespace
}  // namespace limpet
