// SPDX-License-Identifier: MIT
#include "apps/pMap/map_app.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/pMap/map_app_fixture.hpp"

namespace limpet {
namespace {

TEST_F(MapAppTest, ReportsCoverageOfTheGroundItFlewOver) {
  link_.Send(app_, topics::kSurveyArea, kArea);
  Survey({.north = -10, .length = 20}, {});
  const std::optional<Coverage> coverage = link_.Last(topics::kMapCoverage);
  ASSERT_TRUE(coverage);
  EXPECT_NEAR(coverage->seabed, (20.0 + 4.62) * 6.71 / (30.0 * 36.0), 0.02);
}

TEST_F(MapAppTest, TellsPlannersToCountOnSmallerImagesWherePassesMayHaveComeApart) {
  link_.Send(app_, topics::kSurveyArea, kArea);
  for (ObservedFrame frame :
       trial::Fly({.north = -14, .length = 28}, link_.time, {}, {}, random_)) {
    frame.sigma = PlaceSigma{.absolute = 0.6, .beside = 0.6};
    link_.time = frame.exposure;
    link_.Send(app_, topics::kNavCameraFrame, frame);
    app_.Tick(link_.time);
  }
  const auto look = link_.Last(topics::kMapLook);
  ASSERT_TRUE(look && look->seam_allowance);
  EXPECT_GT(*look->seam_allowance, 0.05);
  const auto coverage = link_.Last(topics::kMapCoverage);
  ASSERT_TRUE(coverage && coverage->done_seabed);
  EXPECT_LT(*coverage->done_seabed, coverage->seabed) << "one pass shows its mean all the same";
}

TEST_F(MapAppTest, SendsEachChangedCellOnce) {
  link_.Send(app_, topics::kSurveyArea, kArea);
  Survey({.north = -10, .length = 20}, {});
  link_.published.clear();
  link_.time += Seconds(1.0);
  app_.Tick(link_.time);
  EXPECT_FALSE(link_.Last(topics::kMapDelta));
}

TEST_F(MapAppTest, SeesNothingBeforeTheDive) {
  link_.Send(app_, topics::kSurveyArea, kArea);
  link_.Send(app_, topics::kSurveyPhase, std::string("ALIGN"));
  Survey({.north = -10, .length = 20}, {});
  EXPECT_EQ(link_.Last(topics::kMapCoverage)->seabed, 0.0);
}

TEST_F(MapAppTest, IsSureOfAnObjectAfterOneCleanPass) {
  Survey({.north = -1, .east = 1, .length = 10}, {kYellow});
  Confirm({kYellow});
  ASSERT_EQ(Objects().size(), 1U);
  EXPECT_EQ(Objects()[0].decided, Status::kNew);
  EXPECT_GT(Objects()[0].posterior.present(), 0.95);
}

TEST_F(MapAppTest, DoesNotTakeAFalseDetectionForAnObject) {
  const trial::Sphere ghost{.ned = {4, 1, 5.5}, .color = "yellow", .landmark = 9};
  Survey({.north = -1, .east = 1, .length = 4}, {});
  Survey({.north = 3.8, .east = 1, .length = 0.2}, {ghost});
  Survey({.north = 4, .east = 1, .length = 6}, {});
  Confirm({ghost});
  for (const OpiBelief& opi : Objects()) {
    EXPECT_EQ(opi.decided, Status::kUncertain);
    EXPECT_LT(opi.posterior.present(), 0.5);
  }
}

TEST_F(MapAppTest, CallsAFormerObjectNotInspectedUntilItHasLooked) {
  const SessionPrior prior = Former({{1, {4, 1, 5.5}, "yellow"}});
  link_.Send(app_, topics::kSessionPrior, prior);
  link_.time += Seconds(1.0);
  app_.Tick(link_.time);
  ASSERT_EQ(Objects().size(), 1U);
  EXPECT_EQ(Objects()[0].decided, Status::kNotInspected);
  EXPECT_EQ(Objects()[0].looks, 0);
  EXPECT_GT(Objects()[0].posterior.Entropy(), 0.6);
}

TEST_F(MapAppTest, DecidesAllFourWaysInAChangeSession) {
  const trial::Sphere newcomer{.ned = {4, 8, 6.0}, .color = "orange", .landmark = 4};
  SessionPrior prior = Former({{1, {4.3, 1.2, 5.6}, "yellow"}, {2, {8, -4, 7}, "orange"}});
  AddViews({.north = -3, .east = 8, .length = 16}, prior);
  link_.Send(app_, topics::kSessionPrior, prior);
  Survey({.north = -3, .east = 1, .length = 16}, {kYellow, newcomer});
  Survey({.north = -3, .east = 8, .length = 16}, {kYellow, newcomer});
  Survey({.north = -3, .east = -4, .length = 16}, {kYellow, newcomer});
  Confirm({kYellow, newcomer}, {{kYellow.landmark.value(), 1}});
  std::vector<Status> decided;
  for (const OpiBelief& opi : Objects()) {
    decided.push_back(opi.decided);
    const StatusPosterior& p = opi.posterior;
    EXPECT_NEAR(p.confirmed + p.removed + p.appeared + p.nothing, 1.0, 1e-12);
  }
  EXPECT_THAT(decided, ::testing::ElementsAre(Status::kConfirmed, Status::kRemoved, Status::kNew));
}

TEST_F(MapAppTest, CallsNothingNewOnGroundThatTheFormerSessionNeverSaw) {
  const trial::Sphere seen_ground{.ned = {4, 8, 6.0}, .color = "orange", .landmark = 4};
  SessionPrior prior = Former({});
  AddViews({.north = -3, .east = 8, .length = 16}, prior);
  link_.Send(app_, topics::kSessionPrior, prior);
  for (const double east : {0.5, 1.0, 8.0}) {
    Survey({.north = -3, .east = east, .length = 16}, {kYellow, seen_ground});
  }
  Confirm({kYellow, seen_ground});
  ASSERT_EQ(Objects().size(), 2U);
  EXPECT_EQ(Objects()[0].object.color, "yellow");
  EXPECT_EQ(Objects()[0].decided, Status::kUncertain);
  EXPECT_GT(Objects()[0].posterior.present(), 0.95)
      << "it is there, but may have been there before";
  EXPECT_EQ(Objects()[1].decided, Status::kNew);
}

TEST_F(MapAppTest, JudgesTheFormerViewsByTheFormerCamera) {
  // Seen through a camera of 12 degrees the former session passed by.
  SessionPrior prior = Former({});
  AddViews({.north = -3, .east = 3, .length = 16}, prior);
  prior.map_parameters = {{"camera_fov_across_deg", "12"},
                          {"camera_fov_along_deg", "12"},
                          {"camera_width_px", "480"},
                          {"camera_height_px", "480"},
                          {"object_radius_m", "0.5"}};
  link_.Send(app_, topics::kSessionPrior, prior);
  Survey({.north = -3, .east = 1, .length = 16}, {kYellow});
  Confirm({kYellow});
  EXPECT_EQ(Objects()[0].decided, Status::kUncertain);
}

TEST_F(MapAppTest, DoesNotTrustViewsOfAMapThatItDoesNotUnderstand) {
  SessionPrior prior = Former({});
  AddViews({.north = -3, .east = 1, .length = 16}, prior);
  prior.map_parameters = {{"visibility_m", "thick"}};
  link_.Send(app_, topics::kSessionPrior, prior);
  ASSERT_TRUE(app_.warnings().contains("FORMER_PARAMETERS"));
  EXPECT_THAT(app_.warnings().at("FORMER_PARAMETERS").text, ::testing::HasSubstr("visibility_m"));
  Survey({.north = -3, .east = 1, .length = 16}, {kYellow});
  Confirm({kYellow});
  EXPECT_EQ(Objects()[0].decided, Status::kUncertain);
}

TEST_F(MapAppTest, TrustsTheNextFormerSessionThatItUnderstands) {
  SessionPrior prior = Former({});
  prior.map_parameters = {{"visibility_m", "thick"}};
  link_.Send(app_, topics::kSessionPrior, prior);
  ASSERT_TRUE(app_.warnings().contains("FORMER_PARAMETERS"));
  link_.Send(app_, topics::kSessionPrior, Former({}));
  EXPECT_FALSE(app_.warnings().contains("FORMER_PARAMETERS"));
}

TEST_F(MapAppTest, SurvivesViewsOutOfOrder) {
  SessionPrior prior = Former({});
  AddViews({.north = -3, .east = 1, .length = 16}, prior);
  prior.views.push_back(prior.views.front());
  link_.Send(app_, topics::kSessionPrior, prior);
  Survey({.north = -3, .east = 1, .length = 16}, {kYellow});
  Confirm({kYellow});
  EXPECT_EQ(Objects()[0].decided, Status::kNew);
}

TEST_F(MapAppTest, PutsTheCentroidAtTheSpheresCentre) {
  const trial::Sphere off_grid{.ned = {4.07, 1.03, 5.56}, .color = "yellow", .landmark = 3};
  Survey({.north = -1, .east = 0, .length = 10}, {off_grid});
  Confirm({off_grid});
  ASSERT_EQ(Objects().size(), 1U);
  const Eigen::Vector3d centroid = Objects()[0].centroid_W;
  EXPECT_LT((centroid - off_grid.ned).norm(), 0.2);
  EXPECT_NE(centroid.x(), off_grid.ned.x()) << "from the voxels, not from the smoother";
  EXPECT_NEAR(Objects()[0].centroid_sd_W[0], 0.25, 0.1);
}

TEST_F(MapAppTest, SendsItsMapOnRequest) {
  link_.Send(app_, topics::kNavBeams,
             PosedBeams{.down = 3.5, .b1 = 4.4, .b2 = 4.4, .b3 = 4.4, .b4 = 4.4, .sd_down = 0.07});
  Survey({.north = -1, .east = 0, .length = 10}, {kYellow});
  Confirm({kYellow});
  link_.Send(app_, topics::kMapSnapshotRequest, std::string("test"));
  const Expected<SemanticOctree> map = ToldMap();
  ASSERT_TRUE(map);
  const std::optional<VoxelBelief> top = map->At(kYellow.ned - Eigen::Vector3d(0, 0, 0.45));
  ASSERT_TRUE(top);
  EXPECT_GT(top->object, std::log(0.7 / 0.3));
  EXPECT_EQ(top->label, VoxelLabel::kNew);
}

/// Pings 12.8 m apart are each in a tile of its own.
PosedBeams PingInTile(int north) {
  return {.north = 6.4 + 12.8 * north,
          .east = 6.4,
          .down = 3.5,
          .b1 = 4.4,
          .b2 = {},
          .b3 = {},
          .b4 = {},
          .sd_down = {}};
}

TEST_F(MapAppTest, TellsOnlyWhatIsOtherInItsMapAndAllOfItOnRequest) {
  const auto ask = [this](const Topic<std::string>& topic) {
    link_.published.clear();
    link_.Send(app_, topic, std::string("test"));
    return link_.Count(topics::kMapTile);
  };
  for (int i = 0; i < 3; ++i)
    link_.Send(app_, topics::kNavBeams, PingInTile(i));
  EXPECT_EQ(ask(topics::kMapSnapshotRequest), 3);
  EXPECT_EQ(link_.Last(topics::kMapTiles)->tiles, 3);
  EXPECT_EQ(ask(topics::kMapSnapshotRequest), 0);
  link_.Send(app_, topics::kNavBeams, PingInTile(1));
  EXPECT_EQ(ask(topics::kMapSnapshotRequest), 1);
  EXPECT_EQ(link_.Last(topics::kMapTile)->key, (TileKey{1, 0}));
  const MapTileList told = *link_.Last(topics::kMapTiles);
  EXPECT_EQ(ask(topics::kMapTilesRequest), 3);
  EXPECT_EQ(link_.Last(topics::kMapTiles), told);
  MapTileTable heard;
  for (const MessagePtr& message : link_.published) {
    if (message->name == topics::kMapTile.name)
      heard.Put(*TopicCodec<MapTile>::Decode(message->value));
  }
  EXPECT_EQ(heard.List(), told);
}

TEST_F(MapAppTest, TellsALargeMapTickByTick) {
  constexpr int kTiles = MapTeller::kAtOnce + MapTeller::kPerTick + 1;
  for (int i = 0; i < kTiles; ++i)
    link_.Send(app_, topics::kNavBeams, PingInTile(i));
  link_.Send(app_, topics::kMapSnapshotRequest, std::string("test"));
  EXPECT_EQ(link_.Count(topics::kMapTiles), 0);
  for (int i = 0; i < 2; ++i) {
    link_.time += Seconds(0.25);
    app_.Tick(link_.time);
  }
  EXPECT_EQ(link_.Count(topics::kMapTile), kTiles);
  EXPECT_EQ(link_.Last(topics::kMapTiles)->tiles, kTiles);
}

TEST_F(MapAppTest, TellsOfWhatStandsInTheWayAndKeepsItInItsMap) {
  PosedSonar sonar{.down = 3.5, .ping = {.first = -0.1, .step = 0.1, .reach = 15.0, .ranges = {}}};
  sonar.ping.ranges = {0.0, 8.0, 0.0};
  for (int i = 0; i < 6; ++i) {
    link_.time += Seconds(0.25);
    link_.Send(app_, topics::kNavSonar, sonar);
  }
  link_.time += Seconds(1.0);
  app_.Tick(link_.time);
  const std::optional<Obstacles> told = link_.Last(topics::kMapObstacles);
  ASSERT_TRUE(told);
  ASSERT_EQ(told->obstacles.size(), 1U);
  EXPECT_NEAR(told->obstacles[0].outline[0][0], 8.0, 0.2);
  const auto alert = link_.Last(topics::kObstacleAlert);
  ASSERT_TRUE(alert);
  EXPECT_THAT(*alert, ::testing::StartsWith("name=ob_1#poly=pts={"));
  link_.Send(app_, topics::kMapSnapshotRequest, std::string("test"));
  const Expected<SemanticOctree> map = ToldMap();
  ASSERT_TRUE(map);
  const std::optional<VoxelBelief> voxel = map->At({8.0, 0.0, 3.5});
  ASSERT_TRUE(voxel);
  EXPECT_GT(voxel->occupied, 0.0F);
}

TEST_F(MapAppTest, TakesBackCoverageOfGroundThatTheTrackTurnsOutNotToHaveShown) {
  link_.Send(app_, topics::kSurveyArea, kArea);
  SurveyGrid mirror(kArea);
  const auto tick = [&] {
    link_.time += Seconds(1.0);
    app_.Tick(link_.time);
    EXPECT_TRUE(mirror.Apply(*link_.Last(topics::kMapDelta)));
    return *link_.Last(topics::kMapCoverage);
  };
  Survey({.north = -10, .length = 20}, {});
  const Coverage thought = tick();
  EXPECT_GT(thought.seabed, 0.05);
  // It was at the area's edge, half of each image outside.
  link_.Send(app_, topics::kNavTrackShift,
             TrackShift{{{link_.time.value(), 0.0, kArea.east_max, 0.0, 0.0}}});
  for (int i = 0; i < 20; ++i) {
    static_cast<void>(tick());
  }
  const Coverage known = tick();
  EXPECT_NEAR(known.seabed, 0.5 * thought.seabed, 0.2 * thought.seabed);
  EXPECT_NEAR(mirror.coverage().seabed, known.seabed, 1e-9);
}

TEST_F(MapAppTest, SavesWhatAFormerSessionKnewWithWhatItSeesItself) {
  SemanticOctree former;
  former.Set({3.1, 3.1, 7.5}, {.occupied = 2.0F});
  link_.Send(app_, topics::kSessionPriorMap, MapTile::Of({0, 0}, former.Serialize()));
  EXPECT_FALSE(app_.warnings().contains("FORMER_MAP"));
  link_.Send(app_, topics::kSessionPriorMap, MapTile::Of({0, 1}, "x"));
  EXPECT_TRUE(app_.warnings().contains("FORMER_MAP"));
  link_.Send(app_, topics::kNavBeams,
             PosedBeams{.down = 3.5, .b1 = 4.4, .b2 = 4.4, .b3 = 4.4, .b4 = 4.4, .sd_down = {}});
  link_.Send(app_, topics::kMapSnapshotRequest, std::string("test"));
  const Expected<SemanticOctree> map = ToldMap();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->At({3.1, 3.1, 7.5})->occupied, 1.0F);
  EXPECT_TRUE(map->At({0.1, 0.1, 3.7})) << "its own beams, too";
}

TEST_F(MapAppTest, SavesBeamsAndDepthsWhereTheTrackIsNow) {
  const PosedBeams ping{.down = 3.5, .b1 = 4.4, .b2 = 4.4, .b3 = 4.4, .b4 = 4.4, .sd_down = 0.07};
  link_.Send(app_, topics::kNavBeams, ping);
  const auto depths = [this] {
    link_.Send(app_, topics::kMapSnapshotRequest, std::string("test"));
    return *DepthMap::Parse(link_.Last(topics::kMapDepths)->bytes);
  };
  const DepthMap before = depths();
  ASSERT_EQ(before.Columns().size(), 4U);
  EXPECT_EQ(before.zero_sigma(), 0.07);
  link_.Send(app_, topics::kNavTrackShift, TrackShift{{{link_.time.value(), 2.0, 0.0, 0.1, 0.0}}});
  const std::vector<DepthColumn> moved = depths().Columns();
  ASSERT_EQ(moved.size(), 4U);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    EXPECT_NEAR(moved[i].north, before.Columns()[i].north + 2.0, 1e-9);
    EXPECT_NEAR(moved[i].down, before.Columns()[i].down + 0.1, 1e-3);
  }
}

TEST_F(MapAppTest, TellsTheOperatorOfCoverageAndObjects) {
  link_.Send(app_, topics::kSurveyArea, kArea);
  Survey({.north = -2, .east = 1}, {kYellow});
  Confirm({kYellow});
  ReportLines lines;
  app_.Report(lines);
  EXPECT_THAT(lines.Text(), ::testing::HasSubstr("Coverage:     seabed "));
  EXPECT_THAT(lines.Text(), ::testing::HasSubstr("yellow   4.00"));
}

TEST(MapAppArea, RefusesOneThatNoGridCanHoldAndGoesOn) {
  TestLink link;
  AppContext context;
  context.name = "pMap";
  context.link = &link;
  MapApp app(context, MapApp::Params{});
  SurveyArea vast = kArea, inverted = kArea;
  vast.north_max = 2e6;
  inverted.east_max = -19;
  for (const SurveyArea& area : {vast, inverted}) {
    link.Send(app, topics::kSurveyArea, area);
    EXPECT_TRUE(app.warnings().contains("AREA_REFUSED"));
    link.time += Seconds(1.0);
    app.Tick(link.time);
    EXPECT_FALSE(link.Last(topics::kMapCoverage).has_value());
  }
  link.Send(app, topics::kSurveyArea, kArea);
  EXPECT_TRUE(app.warnings().empty());
  link.time += Seconds(1.0);
  app.Tick(link.time);
  EXPECT_TRUE(link.Last(topics::kMapCoverage).has_value());
}

TEST_F(MapAppTest, BareGroundThatDoesNotStandOutIsNotCovered) {
  link_.Send(app_, topics::kSurveyArea, kArea);
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  Survey({.north = -10, .length = 20}, {});
  link_.time += Seconds(1.0);
  app_.Tick(link_.time);
  const double believed = link_.Last(topics::kMapCoverage)->seabed;
  EXPECT_GT(believed, 0.0);
  for (const ObservedFrame& frame :
       trial::Fly({.north = -10, .length = 20}, link_.time, {}, {}, random_)) {
    link_.time = frame.exposure;
    link_.Send(app_, topics::kNavCameraFrame, frame);
    link_.Send(app_, topics::kGroundContrast,
               {.exposure = link_.time.value(), .green = 0.0005, .noise = 0.0008});
    app_.Tick(link_.time);
  }
  EXPECT_LT(link_.Last(topics::kWaterState)->visibility, Meters(4.0));
  const Meters planned = link_.Last(topics::kMapLook)->detection.visibility;
  EXPECT_LT(planned, Meters(4.0)) << "plans follow the water";
  EXPECT_EQ(link_.Last(topics::kMapCoverage)->seabed, 0.0);
  link_.Send(app_, topics::kMapSnapshotRequest, std::string("test"));
  EXPECT_EQ(link_.Last(topics::kWaterRecord)->visibility, planned.value());
  EXPECT_FALSE(link_.Last(topics::kWaterRecord)->contrasts.empty());
}

}  // namespace
}  // namespace limpet
