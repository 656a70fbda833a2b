// SPDX-License-Identifier: MIT
#include "limpet/helm/survey_mirror.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

SurveyArea MirroredArea() {
  return {.north_min = -8, .north_max = 8, .east_min = -8, .east_max = 8};
}

OpiBelief BeliefAt(int id, double north, double east, Status decided = Status::kUncertain) {
  OpiBelief belief;
  belief.id = id;
  belief.object.p_W = {north, east, 7.0};
  belief.decided = decided;
  belief.posterior = {.confirmed = 0.4, .removed = 0.6, .appeared = 0.0, .nothing = 0.0};
  return belief;
}

class SurveyMirrorTest : public ::testing::Test {
 protected:
  SurveyMirrorTest() { mirror_.SetArea(MirroredArea()); }
  /// What the map saw of the area from one place.
  [[nodiscard]] static SurveyGrid SeenAbove(double north, double east) {
    SurveyGrid grid(MirroredArea());
    grid.Observe({{north, east, 3.5}, 0.0, 0.0, 0.0}, 4.0, CameraModel{});
    return grid;
  }
  SurveyMirror mirror_{ViewParams{}};
};

TEST_F(SurveyMirrorTest, TheSameAreaAgainForgetsNothing) {
  mirror_.Apply(SeenAbove(0.0, 0.0).Everything());
  mirror_.UpdateGround();
  EXPECT_FALSE(mirror_.SetArea(MirroredArea()));
  SurveyArea other = MirroredArea();
  other.north_max = 9.0;
  EXPECT_TRUE(mirror_.SetArea(other));
  EXPECT_EQ(mirror_.area()->north_max, 9.0);
}

TEST_F(SurveyMirrorTest, ADeltaOfAnotherAreaIsLateMailAndChangesNothing) {
  SurveyArea other = MirroredArea();
  other.east_max = 20.0;
  SurveyGrid elsewhere(other);
  elsewhere.Observe({{0.0, 0.0, 3.5}, 0.0, 0.0, 0.0}, 4.0, CameraModel{});
  mirror_.UpdateGround();
  const double before = mirror_.seen()(DubinsPath({0.0, -3.0, 1.57}, {{0.0, 6.0}})).new_area;
  mirror_.Apply(elsewhere.Everything());
  mirror_.UpdateGround();
  EXPECT_EQ(mirror_.seen()(DubinsPath({0.0, -3.0, 1.57}, {{0.0, 6.0}})).new_area, before);
  mirror_.Apply(SeenAbove(0.0, 0.0).Everything());
  mirror_.UpdateGround();
  EXPECT_LT(mirror_.seen()(DubinsPath({0.0, -3.0, 1.57}, {{0.0, 6.0}})).new_area, before);
}

TEST_F(SurveyMirrorTest, PathsKeepOffObstaclesUntilTheyAreNone) {
  const std::vector<Obstacle> pile{
      {.id = 1, .outline = {{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, 0.0}}, .top = 0.0}};
  const auto is_free = [this](double north, double east) {
    return mirror_.Snapshot(Seconds(0.0), {}, 0.0).region->Contains(PlanePoint(north, east));
  };
  mirror_.UpdateGround();
  EXPECT_TRUE(is_free(0.5, -1.0));
  EXPECT_TRUE(mirror_.SetObstacles(pile));
  EXPECT_FALSE(mirror_.SetObstacles(pile));
  EXPECT_FALSE(is_free(0.5, -1.0));
  EXPECT_TRUE(is_free(0.5, -1.6));
  EXPECT_TRUE(mirror_.SetObstacles({}));
  EXPECT_TRUE(is_free(0.5, -1.0));
}

TEST_F(SurveyMirrorTest, ObstaclesKnownBeforeTheAreaCountOnceItIs) {
  SurveyMirror mirror{ViewParams{}};
  EXPECT_TRUE(mirror.SetObstacles(
      {{.id = 1, .outline = {{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}, .top = 0.0}}));
  mirror.SetArea(MirroredArea());
  mirror.UpdateGround();
  EXPECT_FALSE(mirror.Snapshot(Seconds(0.0), {}, 0.0).region->Contains(PlanePoint(0.5, 0.8)));
}

TEST_F(SurveyMirrorTest, NoticesObjectsThatCameWentOrWereDecided) {
  EXPECT_TRUE(mirror_.SetObjects({BeliefAt(1, 0.0, 0.0), BeliefAt(2, 3.0, 0.0)}));
  EXPECT_FALSE(mirror_.SetObjects({BeliefAt(1, 0.1, 0.0), BeliefAt(2, 3.0, 0.1)}))
      << "moved a little: nothing to decide anew for";
  EXPECT_TRUE(mirror_.SetObjects({BeliefAt(1, 0.0, 0.0, Status::kRemoved), BeliefAt(2, 3.0, 0.0)}));
  EXPECT_TRUE(mirror_.SetObjects({BeliefAt(2, 3.0, 0.0)}));
}

TEST_F(SurveyMirrorTest, ASnapshotHoldsWhatWasTold) {
  const HomePoint home{.north = 1.0, .east = 2.0};
  mirror_.SetHome(home);
  mirror_.SetCoverage({.seabed = 0.5, .band = 0.25, .band_top = 0.125});
  mirror_.SetObjects({BeliefAt(7, 0.0, 0.0)});
  const Situation now = mirror_.Snapshot(Seconds(12.0), {1.0, 2.0, 0.5}, 34.0);
  EXPECT_EQ(now.now.value(), 12.0);
  EXPECT_EQ(now.pose.yaw, 0.5);
  EXPECT_EQ(now.travelled, 34.0);
  EXPECT_EQ(now.home.east, 2.0);
  EXPECT_EQ(now.coverage.band, 0.25);
  ASSERT_EQ(now.objects.size(), 1U);
  EXPECT_EQ(now.objects[0].belief.id, 7);
  EXPECT_EQ(now.turn_radius, ViewParams{}.turning_radius);
}

TEST_F(SurveyMirrorTest, WithoutALookModelNoObjectHasAWindow) {
  mirror_.SetObjects({BeliefAt(1, 0.0, 0.0)});
  EXPECT_FALSE(mirror_.Snapshot(Seconds(0.0), {}, 0.0).objects[0].window);
  mirror_.SetLookModel(ToMapLook(LookModel{}));
  EXPECT_TRUE(mirror_.Snapshot(Seconds(0.0), {}, 0.0).objects[0].window);
}

TEST_F(SurveyMirrorTest, AnObjectIsSeenFromNarrowerTheNearerItIsBelowTheVehicle) {
  mirror_.SetLookModel(ToMapLook(LookModel{}));
  NavState nav;
  nav.down = 3.5;
  nav.altitude = 4.0;
  mirror_.NoteAltitude(nav);  // the seabed is at 7.5 m
  OpiBelief floating = BeliefAt(2, 0.0, 0.0);
  floating.object.p_W.z() = 5.5;
  mirror_.SetObjects({BeliefAt(1, 0.0, 0.0), floating});
  const auto objects = mirror_.Snapshot(Seconds(0.0), {}, 0.0).objects;
  ASSERT_TRUE(objects[0].window && objects[1].window);
  EXPECT_LT(objects[1].window->half_across, objects[0].window->half_across);
}

TEST_F(SurveyMirrorTest, AnUncertainPlaceLeavesLessOfItsWindow) {
  mirror_.SetLookModel(ToMapLook(LookModel{}));
  OpiBelief vague = BeliefAt(2, 0.0, 0.0);
  vague.object.cov_W = 0.09 * Eigen::Matrix3d::Identity();
  mirror_.SetObjects({BeliefAt(1, 0.0, 0.0), vague});
  const auto objects = mirror_.Snapshot(Seconds(0.0), {}, 0.0).objects;
  ASSERT_TRUE(objects[0].window && objects[1].window);
  EXPECT_NEAR(objects[0].window->half_across - objects[1].window->half_across, 0.3, 1e-6);
}

TEST_F(SurveyMirrorTest, InMurkyWaterLessIsLeftToSee) {
  mirror_.UpdateGround();
  const DubinsPath lane({0.0, -3.0, 1.57}, {{0.0, 6.0}});
  const double clear = mirror_.seen()(lane).new_area;
  LookModel murky;
  murky.detection.visibility = Meters(3.0);
  mirror_.SetLookModel(ToMapLook(murky));
  mirror_.UpdateGround();
  EXPECT_LT(mirror_.seen()(lane).new_area, clear);
}

TEST(SurveyMirrorBand, IsSeenWholeUnlessTheVehicleFliesTooLowForIt) {
  SurveyArea area = MirroredArea();
  SurveyMirror high{ViewParams{}};
  EXPECT_TRUE(high.SeesWholeBand()) << "nothing is known of the area yet";
  high.SetArea(area);
  EXPECT_TRUE(high.SeesWholeBand());
  area.object_height_max = ViewParams{}.survey_altitude.value() - 0.05;
  SurveyMirror low{ViewParams{}};
  low.SetArea(area);
  EXPECT_FALSE(low.SeesWholeBand());
}

TEST_F(SurveyMirrorTest, KeepsPathsFartherOffTheBorderWhereThePlaceIsLessSure) {
  NavState nav;
  nav.sd_north = nav.sd_east = 0.1;
  const auto border = [&] {
    mirror_.NoteAltitude(nav);
    mirror_.UpdateGround();
    return mirror_.Snapshot(Seconds(0.0), Pose2{}, 0.0).region->north_max();
  };
  const double sure = border();
  nav.sd_north = 0.4;
  EXPECT_NEAR(border(), sure - 0.75, 1e-9);
  nav.sd_north = 50.0;
  EXPECT_GE(border(), 8.0) << "the area itself stays inside";
}

TEST_F(SurveyMirrorTest, PlansWithSmallerImagesWherePassesMayHaveComeApart) {
  const auto swath = [&] { return mirror_.Snapshot(Seconds(0.0), Pose2{}, 0.0).ground->swath(); };
  MapLook look = ToMapLook(LookModel{});
  mirror_.SetLookModel(look);
  const double sure = swath();
  look.seam_allowance = 0.2;
  mirror_.SetLookModel(look);
  EXPECT_NEAR(swath(), sure - 0.4, 0.01);
}

SurveyArea SquareKilometre() {
  SurveyArea area = MirroredArea();
  area.north_max = area.north_min + 1000.0;
  area.east_max = area.east_min + 1000.0;
  return area;
}

TEST(SurveyMirrorOfASquareKilometre, PlansABlockAndKnowsWhereItGoesOn) {
  SurveyMirror mirror{ViewParams{}};
  ASSERT_TRUE(mirror.SetArea(SquareKilometre()));
  NavState nav;
  nav.north = nav.east = -8.0;
  mirror.NoteAltitude(nav);
  mirror.UpdateGround();
  const Situation now = mirror.Snapshot(Seconds(0.0), Pose2{-8.0, -8.0, 0.0}, 0.0);
  EXPECT_TRUE(now.ground->is_part());
  EXPECT_LT(now.ground->levels().size(), 250'000U);
  EXPECT_GT(mirror.blocks().count(), 60U);
  ASSERT_TRUE(now.onward_W.has_value());
  EXPECT_LT((*now.onward_W - PlanePoint(-8.0, -8.0)).norm(), 250.0);
}

TEST(SurveyMirrorOfASquareKilometre, LeavesABlockOfWhichThePlanShowsNothingMore) {
  SurveyMirror mirror{ViewParams{}};
  ASSERT_TRUE(mirror.SetArea(SquareKilometre()));
  mirror.UpdateGround();
  const PlanePoint there = *mirror.Snapshot(Seconds(0.0), {}, 0.0).onward_W;
  Option option{.source = "plan", .path = DubinsPath({there.x(), there.y(), 0.0})};
  option.path.Append({.curvature = 0.0, .length = 5.0});
  mirror.NoteChoice(option);
  mirror.UpdateGround();
  EXPECT_EQ(mirror.blocks().index(), 0U) << "what follows it is not known";
  option.own_m = 5.0;
  mirror.NoteChoice(option);
  mirror.UpdateGround();
  EXPECT_EQ(mirror.blocks().index(), 1U);
}

TEST_F(SurveyMirrorTest, GivesUpWhereThePlanShowsNothingMoreAndLacksItsEnd) {
  mirror_.UpdateGround();
  Option outside{.source = "plan", .path = DubinsPath({-300.0, -300.0, 0.0}), .own_m = 5.0};
  outside.path.Append({.curvature = 0.0, .length = 5.0});
  mirror_.NoteChoice(outside);
  EXPECT_FALSE(mirror_.gives_up()) << "its end is the survey's";
  outside.lacking_m = 40.0;
  mirror_.NoteChoice(outside);
  EXPECT_TRUE(mirror_.gives_up());
  Option across{
      .source = "plan", .path = DubinsPath({0.0, -5.0, 1.5}), .own_m = 9.0, .lacking_m = 40.0};
  across.path.Append({.curvature = 0.0, .length = 9.0});
  mirror_.NoteChoice(across);
  EXPECT_FALSE(mirror_.gives_up());
}

TEST_F(SurveyMirrorTest, ASmallAreaIsPlannedAsAWholeAndLeadsHome) {
  mirror_.SetHome({.north = 3.0, .east = 4.0});
  mirror_.UpdateGround();
  const Situation now = mirror_.Snapshot(Seconds(0.0), Pose2{0.0, 0.0, 0.0}, 0.0);
  EXPECT_FALSE(now.ground->is_part());
  EXPECT_EQ(now.next(), PlanePoint(3.0, 4.0));
}

TEST_F(SurveyMirrorTest, NothingIsToBeSeenWhereAnObstacleStands) {
  const auto wanted = [this] {
    mirror_.UpdateGround();
    return mirror_.Snapshot(Seconds(0.0), {}, 0.0).ground->wanted_m2();
  };
  EXPECT_DOUBLE_EQ(wanted(), 256.0);
  mirror_.SetObstacles(
      {{.id = 1, .outline = {{3.0, 2.0}, {3.0, 4.0}, {6.0, 4.0}, {6.0, 2.0}}, .top = 0.0}});
  EXPECT_DOUBLE_EQ(wanted(), 250.0);
  mirror_.SetObstacles({});
  EXPECT_DOUBLE_EQ(wanted(), 256.0);
}

}  // namespace
}  // namespace limpet
