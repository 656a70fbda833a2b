// SPDX-License-Identifier: MIT
#include "limpet/comparison/session_comparison.hpp"

#include <map>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

/// Two sessions that saw nothing, with missions as they say.
class SessionComparisonTest : public ::testing::Test {
 protected:
  SavedSession Saved(const std::string& name, std::map<std::string, std::string> mission) {
    SessionMemory memory;
    memory.mission = std::move(mission);
    EXPECT_TRUE(SessionWriter(folder_.path() / name / "session").Commit({}, FilesOf(memory)));
    return LoadSavedSession(folder_.path() / name, name);
  }
  static std::string ComplaintAbout(const SavedSession& a, const SavedSession& b) {
    try {
      static_cast<void>(CompareSessions(a, b));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(SessionComparisonTest, NamesTheSavedMissionThatItCannotRead) {
  const SavedSession a =
      Saved("discovery", {{"mission.moos", "ProcessConfig = pMap\n{\n  decide_at = 2\n}\n"}});
  EXPECT_THAT(ComplaintAbout(a, Saved("change", {})),
              HasSubstr("discovery/mission/mission.moos:3: decide_at"));
}

TEST_F(SessionComparisonTest, RefusesASessionWithoutAMissionAndSaysWhatHelps) {
  EXPECT_THAT(ComplaintAbout(Saved("discovery", {}), Saved("change", {})), HasSubstr("--mission"));
}

std::map<std::string, std::string> MissionWithMap() {
  return {{"mission.moos",
           "ProcessConfig = pMap\n{\n  camera_fov_across_deg = 80\n  camera_fov_along_deg = 60\n"
           "  camera_width_px = 640\n  camera_height_px = 480\n  object_radius_m = 0.5\n}\n"}};
}

TEST_F(SessionComparisonTest, FindsNothingWhereNothingWasSeen) {
  const SessionComparison comparison =
      CompareSessions(Saved("discovery", MissionWithMap()), Saved("change", MissionWithMap()));
  EXPECT_TRUE(comparison.objects.empty());
  EXPECT_THAT(Json(comparison), HasSubstr("\"changes\": []"));
}

TEST_F(SessionComparisonTest, OfAMovedObjectSaysHowSureThatIs) {
  SessionComparison comparison{.a = {}, .b = {}, .offset = {}, .objects = {}};
  OpiBelief moved;
  moved.decided = Status::kMoved;
  moved.moved_probability = 0.93;
  comparison.objects = {moved, OpiBelief{}};
  EXPECT_THAT(Json(comparison), HasSubstr("\"moved_probability\": 0.93"));
  EXPECT_THAT(Json(comparison), HasSubstr("\"moved_probability\": null"));
}

/// From south of the place (0, 0, 6): looks all along, at it from many sides, sees nothing.
SavedSession EmptyLooks() {
  SavedSession session;
  session.memory.mission = MissionWithMap();
  session.memory.phases = {{0, "SURVEY"}};
  for (int i = 0; i < 40; ++i) {
    ObservedFrame frame;
    frame.frame = i;
    frame.exposure = Seconds(0.5 * i);
    frame.X_WB.p_WB = {-1.2 - 0.2 * (i % 3), -1.2 + 0.06 * i, 3.0};
    frame.altitude = 3.5;
    session.memory.frames.push_back(frame);
  }
  return session;
}

SavedSession WithObject() {
  SavedSession session = EmptyLooks();
  OpiBelief opi;
  opi.id = 1;
  opi.landmark = 0;
  opi.object.color = "yellow";
  opi.object.p_W = {0.0, 0.0, 6.0};
  opi.object.cov_W = 0.01 * Eigen::Matrix3d::Identity();
  opi.posterior = {.appeared = 0.98, .nothing = 0.02};
  opi.log_likelihood_ratio = 5.0;
  opi.looks = 12;
  opi.decided = Status::kNew;
  session.memory.objects.opis = {opi};
  return session;
}

/// Between those looks and the place, higher than the camera.
Obstacles Pile() {
  return {
      {{.id = 1, .outline = {{-0.9, -2.0}, {-0.9, 2.0}, {-0.6, 2.0}, {-0.6, -2.0}}, .top = 1.0}}};
}

OpiBelief ObjectAfter(const SavedSession& b) {
  const SessionComparison comparison = CompareSessions(WithObject(), b);
  EXPECT_EQ(comparison.objects.size(), 1U);
  return comparison.objects.at(0);
}

TEST_F(SessionComparisonTest, HasNotLookedWhereAnObstacleStoodBefore) {
  SavedSession b = EmptyLooks();
  EXPECT_GT(ObjectAfter(b).looks, 3);
  EXPECT_NE(ObjectAfter(b).decided, Status::kNotInspected);
  b.memory.obstacles = Pile();
  EXPECT_EQ(ObjectAfter(b).looks, 0);
  EXPECT_EQ(ObjectAfter(b).decided, Status::kNotInspected);
}

TEST_F(SessionComparisonTest, KnowsTheObstaclesThatASessionSaved) {
  SavedSession b = EmptyLooks();
  b.memory.obstacles = Pile();
  const Expected<SessionMemory> again = MemoryOf(FilesOf(b.memory));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->obstacles.obstacles, Pile().obstacles);
}

/// What hid a place from the former session: an object that is first seen there is not sure to be
/// new.
TEST_F(SessionComparisonTest, TakesNothingForNewThatAnObstacleHidFromTheFormerSession) {
  SavedSession b = EmptyLooks();
  Landmark landmark;
  landmark.id = 0;
  landmark.object.color = "yellow";
  landmark.object.p_W = {0.0, 0.0, 6.0};
  landmark.object.cov_W = 0.01 * Eigen::Matrix3d::Identity();
  b.memory.known_landmarks = Landmarks{{landmark}};
  for (ObservedFrame& frame : b.memory.frames) {
    frame.boxes = {{.u = 320,
                    .v = 100,
                    .w = 60,
                    .h = 60,
                    .confidence = 0.9,
                    .color = "yellow",
                    .landmark = 0}};
  }
  SavedSession a = EmptyLooks();
  const auto chance_of_new = [&] {
    const SessionComparison comparison = CompareSessions(a, b);
    return comparison.objects.empty() ? 0.0 : comparison.objects.at(0).posterior.appeared;
  };
  const double seen_empty_before = chance_of_new();
  a.memory.obstacles = Pile();
  EXPECT_LT(chance_of_new(), seen_empty_before);
}

}  // namespace
}  // namespace limpet
