// SPDX-License-Identifier: MIT
#include "estimation/matching/session_matching.hpp"

#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;

ObjectEstimate FormerAt(double north, double east, const std::string& color = "yellow") {
  return {.p_W = {north, east, 6.0}, .cov_W = 0.04 * Eigen::Matrix3d::Identity(), .color = color};
}

TEST(MatchSessions, FindsTheOffsetThatAllObjectsShare) {
  const std::vector<ObjectEstimate> former{FormerAt(4, 1), FormerAt(2, 10), FormerAt(6, -3),
                                           FormerAt(-6, -5)};
  std::vector<ObjectEstimate> now;
  for (const ObjectEstimate& object : former) {
    now.push_back(FormerAt(object.p_W.x() + 0.8, object.p_W.y() - 0.6));
  }
  const SessionMatch match = MatchSessions(former, now, {});
  EXPECT_THAT(match.now_of_former, ElementsAre(0, 1, 2, 3));
  EXPECT_NEAR(match.offset.shift_W.x(), 0.8, 0.2);
  EXPECT_NEAR(match.offset.shift_W.y(), -0.6, 0.2);
}

TEST(MatchSessions, FindsTheTurnFromTwoMatches) {
  const std::vector<ObjectEstimate> former{FormerAt(-14, 0), FormerAt(14, 0)};
  const double turn = RadiansFromDegrees(2.0);
  std::vector<ObjectEstimate> now;
  for (const ObjectEstimate& object : former) {
    now.push_back(FormerAt(object.p_W.x() * std::cos(turn), object.p_W.x() * std::sin(turn)));
  }
  MatchingParams params;
  params.turn_sigma = Radians::FromTextUnit(5.0);
  EXPECT_NEAR(MatchSessions(former, now, params).offset.turn, turn, 0.2 * turn);
}

TEST(MatchSessions, DoesNotTurnTheFrameForOneMatch) {
  EXPECT_EQ(MatchSessions({FormerAt(4, 1)}, {FormerAt(4.5, 1)}, {}).offset.turn, 0.0);
}

TEST(MatchSessions, LeavesRemovedAndNewObjectsAlone) {
  const SessionMatch match =
      MatchSessions({FormerAt(4, 1), FormerAt(2, 10), FormerAt(-6, -5)},
                    {FormerAt(-6.2, -5.1), FormerAt(-3, 11), FormerAt(4.1, 1.2)}, {});
  EXPECT_THAT(match.now_of_former, ElementsAre(2, std::nullopt, 0));
}

TEST(MatchSessions, IsNotLedAstrayByANewNeighbour) {
  // The former object went; a new one came 1.6 m away. Two others say the frames agree.
  const SessionMatch match =
      MatchSessions({FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8)},
                    {FormerAt(1.9, 0, "orange"), FormerAt(8, 0.1), FormerAt(0.1, 8)}, {});
  EXPECT_THAT(match.now_of_former, ElementsAre(std::nullopt, 1, 2));
}

TEST(MatchSessions, TakesAnotherColourForAnotherObjectUnlessItStandsWhereTheFormerDid) {
  const auto match_at = [](double east, const MatchingParams& params) {
    return MatchSessions({FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8)},
                         {FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8 + east, "orange")}, params);
  };
  EXPECT_THAT(match_at(0.1, {}).now_of_former, ElementsAre(0, 1, 2));
  EXPECT_THAT(match_at(1.0, {}).now_of_former, ElementsAre(0, 1, std::nullopt));
  // Of a detector that is never wrong about it.
  EXPECT_THAT(match_at(0.1, {.color_penalty = 30.0}).now_of_former,
              ElementsAre(0, 1, std::nullopt));
}

TEST(MatchSessions, PrefersTheColourThatFits) {
  const SessionMatch match =
      MatchSessions({FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8), FormerAt(0, 8.6, "orange")},
                    {FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8.2, "orange")}, {});
  EXPECT_THAT(match.now_of_former, ElementsAre(0, 1, std::nullopt, 2));
}

TEST(MatchSessions, LeavesAnObjectThatMovedUnmatched) {
  const SessionMatch match = MatchSessions({FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8)},
                                           {FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 9.5)}, {});
  EXPECT_THAT(match.now_of_former, ElementsAre(0, 1, std::nullopt));
}

TEST(MatchSessions, IsSureOfWhatNothingRivals) {
  const SessionMatch match = MatchSessions({FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8)},
                                           {FormerAt(0.3, 0.2), FormerAt(8.3, 0.2)}, {});
  EXPECT_EQ(match.chance(0, 0), 1.0);
  EXPECT_EQ(match.chance(1, 1), 1.0);
  EXPECT_EQ(match.chance.row(2).sum(), 0.0);
}

TEST(MatchSessions, SharesTheChanceBetweenTwoFormerObjectsThatItCouldBe) {
  const SessionMatch match =
      MatchSessions({FormerAt(0, 0), FormerAt(0, 1)}, {FormerAt(0, 0.5)}, {});
  EXPECT_NEAR(match.chance(0, 0), 0.5, 0.02);
  EXPECT_NEAR(match.chance(1, 0), 0.5, 0.02);
}

TEST(MatchSessions, ADoubtElsewhereIsNoneHere) {
  std::vector<ObjectEstimate> former{FormerAt(0, 0)}, now{FormerAt(0, 0)};
  for (int i = 1; i < 8; ++i) {  // pairs of which one is left each
    former.push_back(FormerAt(12.0 * i, -0.5));
    former.push_back(FormerAt(12.0 * i, 0.5));
    now.push_back(FormerAt(12.0 * i, 0.0));
  }
  EXPECT_EQ(MatchSessions(former, now, {}).chance(0, 0), 1.0);
}

TEST(FitSessions, GivesTheOffsetOfTheMatchesItIsGiven) {
  const std::vector<ObjectEstimate> former{FormerAt(0, 0), FormerAt(8, 0), FormerAt(0, 8)};
  const std::vector<ObjectEstimate> now{FormerAt(0.5, 8), FormerAt(0.5, 0), FormerAt(8.5, 0)};
  const SessionMatch fit = FitSessions(former, now, {1, 2, 0}, {});
  EXPECT_THAT(fit.now_of_former, ElementsAre(1, 2, 0));
  EXPECT_NEAR(fit.offset.shift_W.x(), 0.5, 0.12);
  EXPECT_NEAR(fit.offset.shift_W.y(), 0.0, 0.05);
  EXPECT_EQ(FitSessions(former, {}, FormerMatches(3), {}).offset.shift_W.norm(), 0.0);
}

TEST(MatchSessions, WorksWithNothingToMatch) {
  EXPECT_TRUE(MatchSessions({}, {FormerAt(0, 0)}, {}).now_of_former.empty());
  EXPECT_THAT(MatchSessions({FormerAt(0, 0)}, {}, {}).now_of_former, ElementsAre(std::nullopt));
}

TEST(FrameOffset, UndoIsTheInverseOfApply) {
  const FrameOffset offset{.shift_W = {0.5, -0.3}, .turn = 0.1, .pivot_W = {3.0, 4.0}};
  const Eigen::Vector3d point(7.0, -2.0, 5.0);
  EXPECT_LT((offset.Undo(offset.Apply(point)) - point).norm(), 1e-12);
}

}  // namespace
}  // namespace limpet
