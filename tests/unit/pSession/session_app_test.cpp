// SPDX-License-Identifier: MIT
#include "apps/pSession/session_app.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/session/saved_session.hpp"
#include "tests/unit/pSession/session_app_fixture.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

TEST_F(SessionAppTest, KeepsPicturesOfItsObjectsAndOfNothingElse) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  ObservedFrame frame;
  frame.exposure = link_.time;
  frame.boxes = {
      {.u = 99, .v = 99, .w = 30, .h = 30, .confidence = 0.9, .color = "yellow", .landmark = 3},
      {.u = 400, .v = 99, .w = 30, .h = 30, .confidence = 0.9, .color = "yellow", .landmark = 8}};
  link_.Send(app, topics::kDetectionChips,
             ImageChips{.exposure = frame.exposure,
                        .chips = {{.box = frame.boxes[0], .jpeg = "object"},
                                  {.box = frame.boxes[1], .jpeg = "no object"}}});
  link_.Send(app, topics::kNavCameraFrame, frame);
  link_.Send(app, topics::kMapOpis, OneObject());
  link_.Send(app, topics::kSessionSave, std::string("home"));
  TellMap(app, "1");
  const auto saved = LoadSavedSession(folder_.path() / "discovery", "session");
  ASSERT_EQ(saved.memory.chips.size(), 1U);
  EXPECT_EQ(saved.memory.chips[0].object, 1);
  EXPECT_EQ(saved.memory.chips[0].chip.jpeg, "object");
}

TEST_F(SessionAppTest, KeepsItsFramesWhereTheSmootherMovesThem) {
  SessionApp app(Context("discovery"), {});
  ObservedFrame frame;
  frame.exposure = link_.time, frame.X_WB.p_WB = {1, 2, 3};
  link_.Send(app, topics::kNavCameraFrame, frame);
  const double t = link_.time.value();
  link_.Send(app, topics::kNavTrackShift,
             TrackShift{{{t - 5.0, 0.0, 0.0, 0.0, 0.0}, {t + 5.0, 1.0, -2.0, 0.0, 0.1}}});
  app.Finish(link_.time);
  const Expected<StoredSession> stored = LoadSession(folder_.path() / "discovery");
  ASSERT_TRUE(stored);
  const Expected<SessionMemory> memory = MemoryOf(stored->files);
  ASSERT_TRUE(memory);
  EXPECT_NEAR(memory->frames[0].X_WB.p_WB.x(), 1.5, 1e-3);
  EXPECT_NEAR(memory->frames[0].X_WB.p_WB.y(), 1.0, 1e-3);
  EXPECT_NEAR(memory->frames[0].X_WB.yaw, 0.05, 1e-3);
}

TEST_F(SessionAppTest, IsSelfDescribingFromItsFirstSecond) {
  fs::create_directories(folder_.path() / "table1");
  std::ofstream(folder_.path() / "table1" / "mission.moos") << "Community = alpha\n";
  std::ofstream(folder_.path() / "table1" / "scenario.yaml") << "the truth\n";
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  const Expected<StoredSession> stored = LoadSession(folder_.path() / "discovery");
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->facts.mission, "table1");
  EXPECT_EQ(stored->files.at("mission/mission.moos"), "Community = alpha\n");
  EXPECT_FALSE(stored->files.contains("mission/scenario.yaml"));
}

TEST_F(SessionAppTest, KeepsBehaviorsWithTheirPlugsInPlace) {
  fs::create_directories(folder_.path() / "table1" / "plugs");
  std::ofstream(folder_.path() / "table1" / "mission.bhv")
      << "#define ALTITUDE 4\n#include plug_hold.bhv\n";
  std::ofstream(folder_.path() / "table1" / "plugs" / "plug_hold.bhv")
      << "Behavior = BHV_HoldAltitude\n{\n  altitude_m = $(ALTITUDE)\n}\n";
  std::ofstream(folder_.path() / "table1" / "broken.bhv") << "#include nowhere.bhv\n";
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  const Expected<StoredSession> stored = LoadSession(folder_.path() / "discovery");
  ASSERT_TRUE(stored);
  EXPECT_THAT(stored->files.at("mission/mission.bhv"), testing::HasSubstr("  altitude_m = 4\n"));
  EXPECT_EQ(stored->files.at("mission/broken.bhv"), "#include nowhere.bhv\n");
}

TEST_F(SessionAppTest, SavesNothingTwiceWhenItGoesThroughItsFormerLife) {
  Discover();
  link_.replays = true;
  Discover();
  EXPECT_EQ(LoadSession(folder_.path() / "discovery")->generation, 2);
}

TEST_F(SessionAppTest, KeepsTheDepthsThatCameWithTheMap) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  link_.Send(app, topics::kMapDepths, PackedBytes{"d"});
  TellMap(app, "m");
  const SavedSession saved = LoadSavedSession(folder_.path() / "discovery", "session");
  EXPECT_EQ(saved.memory.depths, "d");
  EXPECT_EQ(FilesOf(saved.memory).at("depths.csv"), "d");
}

TEST_F(SessionAppTest, KeepsTheMissionAsItWasRun) {
  AppContext context = Context("discovery");
  context.globals = {{"Community", "alpha", {}}};
  context.blocks = {{.name = "pMap",
                     .where = {},
                     .entries = {{"visibility_m", "5.5", {}}, {"camera_width_px", "800", {}}}}};
  SessionApp app(context, {});
  app.Tick(link_.time);
  const SavedSession saved = LoadSavedSession(folder_.path() / "discovery", "session");
  EXPECT_THAT(saved.memory.mission.at("as_run.moos"), testing::HasSubstr("Community = alpha\n"));
  const std::optional<ConfigBlock> block = BlockOf(saved, "pMap");
  ASSERT_TRUE(block);
  ASSERT_EQ(block->entries.size(), 2U);
  EXPECT_EQ(block->entries[0].value, "5.5");
  const SessionPrior prior = PriorWithParameters(saved);
  EXPECT_EQ(prior.map_parameters[1][1], "800");
}

TEST_F(SessionAppTest, KeepsThePhasesOfItsFramesAndTheLandmarksOfItsObjects) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  const auto see = [&](double north) {
    ObservedFrame frame;
    frame.exposure = link_.time += Seconds(1.0);
    frame.X_WB.p_WB = {north, 0, 3};
    frame.altitude = 4.0;
    link_.Send(app, topics::kNavCameraFrame, frame);
  };
  see(1.0);
  link_.Send(app, topics::kSurveyPhase, std::string("ALIGN"));
  see(2.0);
  link_.Send(app, topics::kSurveyPhase, std::string("SUR,VEY\n"));
  link_.Send(app, topics::kSurveyPhase, std::string("SURVEY"));
  see(3.0);
  link_.Send(app, topics::kNavLandmarks, Landmarks{{Landmark{}}});
  link_.Send(app, topics::kMapOpis, OneObject());
  link_.Send(app, topics::kNavLandmarks, Landmarks{});
  app.Finish(link_.time + Seconds(1.0));
  const SavedSession saved = LoadSavedSession(folder_.path() / "discovery", "session");
  EXPECT_THAT(PhaseOfFrames(saved.memory), testing::ElementsAre("", "ALIGN", "SURVEY"));
  ASSERT_TRUE(saved.memory.known_landmarks);
  EXPECT_EQ(saved.memory.known_landmarks->landmarks.size(), 1U);
  const SessionPrior prior = PriorWithParameters(saved);
  ASSERT_EQ(prior.views.size(), 2U) << "at the surface the map does not look";
  EXPECT_EQ(prior.views[1].frame.X_WB.p_WB.x(), 3.0);
}

TEST_F(SessionAppTest, WarnsWhileItCannotSave) {
  std::ofstream(folder_.path() / "discovery") << "a file where the run's folder should be\n";
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  EXPECT_TRUE(app.warnings().contains("SESSION_NOT_SAVED"));
  fs::remove(folder_.path() / "discovery");
  link_.Send(app, topics::kSessionSave, std::string("home"));
  EndMap(app);
  EXPECT_FALSE(app.warnings().contains("SESSION_NOT_SAVED"));
  EXPECT_TRUE(LoadSession(folder_.path() / "discovery"));
}

TEST_F(SessionAppTest, SavesEveryMinute) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  app.Tick(link_.time + Seconds(59.0));
  EXPECT_FALSE(link_.Last(topics::kMapSnapshotRequest));
  app.Tick(link_.time + Seconds(60.0));
  EXPECT_EQ(link_.Last(topics::kMapSnapshotRequest), "periodic");
}

/// What is written as a whole each minute would fill the disk of a long survey.
TEST_F(SessionAppTest, SavesLessOftenWhereMuchIsToBeWritten) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  const auto asked_after = [&](Seconds time) {
    link_.time += time;
    app.Tick(link_.time);
    return link_.Count(topics::kMapSnapshotRequest);
  };
  EXPECT_EQ(asked_after(Seconds(60.0)), 1);
  link_.Send(app, topics::kMapDepths, PackedBytes{std::string(25'600'000, 'd')});
  EndMap(app);
  EXPECT_EQ(asked_after(Seconds(199.0)), 1);
  EXPECT_EQ(asked_after(Seconds(2.0)), 2);
}

TEST_F(SessionAppTest, SavesWhatCameLateAtTheEnd) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kMapOpis, OneObject());
  app.Finish(link_.time + Seconds(1.0));
  EXPECT_THAT(LoadSession(folder_.path() / "discovery")->files.at("objects.json"),
              ::testing::HasSubstr("yellow"));
}

TEST_F(SessionAppTest, HandsTheFormerSessionOverAtItsStart) {
  Discover();
  SessionApp app(Context("change", folder_.path() / "discovery"), {});
  EXPECT_FALSE(link_.Last(topics::kSessionPrior));
  app.Tick(link_.time);
  const std::optional<SessionPrior> prior = link_.Last(topics::kSessionPrior);
  ASSERT_TRUE(prior);
  EXPECT_EQ(prior->session, "discovery");
  ASSERT_EQ(prior->former.objects.size(), 1U);
  EXPECT_EQ(prior->former.objects[0].object.color, "yellow");
}

TEST_F(SessionAppTest, RefusesADamagedFormerSessionByName) {
  Discover();
  const fs::path objects = folder_.path() / "discovery" / "session" / "g000002" / "objects.json";
  std::ofstream(objects, std::ios::app) << " ";
  try {
    SessionApp app(Context("change", folder_.path() / "discovery"), {});
    FAIL() << "took a damaged session";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("objects.json: damaged"));
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "change"));
}

TEST_F(SessionAppTest, RefusesAMissingFormerSession) {
  EXPECT_THROW(SessionApp(Context("change", folder_.path() / "nowhere"), {}), ConfigError);
}

TEST_F(SessionAppTest, TellsTheOperatorWhatIsOnDisk) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kMapOpis, OneObject());
  link_.time += Seconds(7.0);
  ReportLines lines;
  app.Report(lines);
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Saved:        generation 1, 7 s ago (start)"));
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Holds:        1 objects, 0 frames"));
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Former:       none"));
}

}  // namespace
}  // namespace limpet
