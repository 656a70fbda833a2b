// SPDX-License-Identifier: MIT
#include "estimation/navigation/session_matching.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;

FormerObject Former(int id, double north, double east) {
  return {.id = id,
          .p = {north, east, 6.0},
          .covariance = 0.05 * Eigen::Matrix3d::Identity(),
          .color = "yellow"};
}
PresentObject Present(double north, double east) {
  return {
      .p = {north, east, 6.0}, .covariance = 0.05 * Eigen::Matrix3d::Identity(), .color = "yellow"};
}

const std::vector<FormerObject> kTable1{Former(1, 4, 1), Former(2, 2, 10), Former(3, 6, -3),
                                        Former(4, -6, -5)};

TEST(MatchSessions, FindsWhatStayedUnderACommonOffset) {
  const std::vector<PresentObject> now{Present(-5.3, -5.8), Present(4.7, 0.2)};
  EXPECT_THAT(MatchSessions(kTable1, now, {}), ElementsAre(4, 1));
}

TEST(MatchSessions, LeavesANewObjectUnmatched) {
  const std::vector<PresentObject> now{Present(4.1, 1.1), Present(-3.0, 11.0)};
  EXPECT_THAT(MatchSessions(kTable1, now, {}), ElementsAre(1, -1));
}

TEST(MatchSessions, AnObjectThatCameNearAFormerOneDoesNotDragTheOthers) {
  // The frames agree; one object stands 1.5 m from where another was.
  const std::vector<PresentObject> now{Present(4.0, 1.0), Present(6.0, -3.0), Present(2.0, 11.5)};
  EXPECT_THAT(MatchSessions(kTable1, now, {}), ElementsAre(1, 3, -1));
}

TEST(MatchSessions, NeverMatchesTwoToOne) {
  const std::vector<PresentObject> now{Present(4.1, 1.0), Present(3.9, 1.1)};
  const std::vector<int> ids = MatchSessions(kTable1, now, {});
  EXPECT_EQ(std::ranges::count(ids, 1), 1);
}

TEST(MatchSessions, HasNothingToSayWithoutFormerObjects) {
  EXPECT_THAT(MatchSessions({}, {Present(1, 1)}, {}), ElementsAre(-1));
}

}  // namespace
}  // namespace limpet
