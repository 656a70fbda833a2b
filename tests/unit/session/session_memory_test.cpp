// SPDX-License-Identifier: MIT
#include "limpet/session/session_memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/lower_triangle.hpp"
#include "limpet/session/frames_csv.hpp"

namespace limpet {
namespace {

OpiBelief Object(int id, std::optional<int> landmark, double probability) {
  OpiBelief opi;
  opi.id = id;
  opi.landmark = landmark;
  opi.object.p_W = {4, 1, 5.5};
  opi.object.cov_W = Eigen::Vector3d(0.04, 0.04, 0.09).asDiagonal();
  opi.object.color = "yellow";
  opi.posterior = {.appeared = probability, .nothing = 1.0 - probability};
  opi.looks = 5;
  opi.log_likelihood_ratio = 8.5;
  return opi;
}

ObservedFrame Frame(int number) {
  ObservedFrame frame;
  frame.frame = number;
  frame.exposure = Seconds(1767225600.0 + 0.25 * number);
  return frame;
}

SessionMemory Sample() {
  SessionMemory memory;
  memory.area = SurveyArea{.north_min = -15, .north_max = 15, .east_min = -18, .east_max = 18};
  memory.objects.opis = {Object(1, 3, 0.98)};
  memory.landmarks = {.ids = {3}, .cov_W = *FromLowerTriangle({0.04, 0.01, 0.05, 0.0, 0.0, 0.09})};
  ObservedFrame frame = Frame(12);
  frame.X_WB.p_WB = {1.5, -2.25, 3.5};
  frame.X_WB.yaw = 0.5;
  frame.altitude = 4.0;
  frame.boxes = {
      {.u = 320.5, .v = 100, .w = 80, .h = 81, .confidence = 0.9, .color = "yellow", .landmark = 3},
      {.u = 10, .v = 20, .w = 30, .h = 40, .confidence = 0.5, .color = "green"}};
  memory.frames = {frame, Frame(13)};
  memory.map = {{"map/-1_0.ot.gz", std::string("\0gz", 3)}, {"map/0_0.ot.gz", "ground"}};
  memory.water = WaterRecord{.visibility = 3.5,
                             .estimate = {.visibility = Meters(3.1), .sd = Meters(1.4)},
                             .contrasts = {{.from = 3.75, .clear = 2, .log_contrast = -4.25}}};
  memory.mission["mission.moos"] = "Community = alpha\n";
  return memory;
}

TEST(SessionMemory, ComesBackFromItsFiles) {
  const SessionMemory saved = Sample();
  const Expected<SessionMemory> loaded = MemoryOf(FilesOf(saved));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(FilesOf(*loaded), FilesOf(saved));
  EXPECT_EQ(loaded->frames.size(), 2U);
  EXPECT_EQ(loaded->frames[0].boxes[1].color, "green");
  EXPECT_FALSE(loaded->frames[1].altitude);
  EXPECT_EQ(loaded->map, saved.map);
}

TEST(SessionMemory, KeepsTheTilesOfItsMapAsFilesOfTheirNames) {
  const SessionMemory saved = Sample();
  const SessionFiles files = FilesOf(saved);
  EXPECT_EQ(files.at("map/-1_0.ot.gz"), saved.map.at("map/-1_0.ot.gz"));
  EXPECT_EQ(files.at("map/0_0.ot.gz"), "ground");
  EXPECT_FALSE(files.contains("map.ot"));
}

TEST(SessionMemory, ReadsTheMapOfSessionsThatHaveItInOneFile) {
  SessionMemory memory = Sample();
  memory.map.clear();
  SessionFiles files = FilesOf(memory);
  files["map.ot"] = std::string("\0ot", 3);
  const Expected<SessionMemory> loaded = MemoryOf(files);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->map, (SessionMap{{"map.ot", std::string("\0ot", 3)}}));
  EXPECT_EQ(FilesOf(*loaded), files);
}

TEST(SessionMemory, NamesTheFileThatItDoesNotUnderstand) {
  SessionFiles files = FilesOf(Sample());
  files["frames.csv"] += "12,not a number\n";
  const Expected<SessionMemory> loaded = MemoryOf(files);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().text, ::testing::StartsWith("frames.csv: line 4"));
}

TEST(SessionMemory, ReadsTheFramesOfSessionsThatCallThemSights) {
  SessionFiles files = FilesOf(Sample());
  files["sights.csv"] = files.at("frames.csv");
  files.erase("frames.csv");
  const Expected<SessionMemory> loaded = MemoryOf(files);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->frames.size(), 2U);
}

TEST(SessionPrior, TellsHowFarTheSessionSawIfItSaidSo) {
  SessionMemory memory = Sample();
  EXPECT_EQ(PriorOf({}, memory).water->visibility, Meters(3.1));
  EXPECT_EQ(PriorOf({}, memory).water->sd, Meters(1.4));
  memory.water.reset();  // an older session
  EXPECT_FALSE(PriorOf({}, memory).water);
}

TEST(SessionMemory, NamesARecordOfTheWaterThatIsNone) {
  SessionFiles files = FilesOf(Sample());
  files["water.json"] = "{\"visibility\": \"far\"}";
  EXPECT_THAT(MemoryOf(files).error().text, ::testing::HasSubstr("water.json"));
}

TEST(SessionPrior, HandsOverObjectsThatWereThere) {
  SessionMemory memory = Sample();
  memory.objects.opis.push_back(Object(2, std::nullopt, 0.02));
  SessionFacts facts;
  facts.session = "discovery";
  const SessionPrior prior = PriorOf(facts, memory);
  ASSERT_EQ(prior.former.objects.size(), 1U);
  EXPECT_EQ(prior.former.objects[0].id, 1);
  EXPECT_EQ(prior.former.objects[0].log_likelihood_ratio, 8.5);
  EXPECT_EQ(prior.session, "discovery");
}

TEST(SessionPrior, HandsOverWhereItLookedFromHalfAMetreApart) {
  SessionMemory memory;
  for (int i = 0; i <= 40; ++i) {
    memory.frames.push_back(Frame(i));
    memory.frames.back().X_WB.p_WB = {0.125 * i, 0.0, 3.5};
    memory.frames.back().altitude = 4.0;
  }
  const SessionPrior prior = PriorOf(SessionFacts{}, memory);
  ASSERT_EQ(prior.views.size(), 11U);
  const FormerView& second = prior.views[1];
  EXPECT_EQ(second.frame.exposure, Seconds(1.0));
  EXPECT_EQ(second.frame.X_WB.p_WB, Eigen::Vector3d(0.5, 0.0, 3.5));
  EXPECT_EQ(second.frame.X_WB.yaw, 0.0);
  EXPECT_EQ(second.frame.altitude, 4.0);
  EXPECT_EQ(second.altitude_age, Seconds(0.0));
}

TEST(SessionPrior, KeepsLooksWholeThatSawWhatIsNotListed) {
  SessionMemory memory;
  memory.objects.opis = {Object(1, 3, 0.98)};
  for (int i = 0; i < 12; ++i) {
    memory.frames.push_back(Frame(i));
    memory.frames.back().X_WB.p_WB = {0.125 * i, 0.0, 3.5};
    memory.frames.back().altitude = 4.0;
    memory.frames.back().boxes = {{.color = "listed", .landmark = 3}};
  }
  memory.frames[5].boxes.push_back({.u = 7.0, .color = "stranger"});
  const SessionPrior prior = PriorOf(SessionFacts{}, memory);
  ASSERT_EQ(prior.views.size(), 6U);  // of looks of four frames the second is kept whole
  for (std::size_t i = 0; i < prior.views.size(); ++i) {
    EXPECT_EQ(prior.views[i].frame.boxes.size(), i == 2 ? 1U : 0U);
  }
  EXPECT_EQ(prior.views[2].frame.boxes.at(0).color, "stranger");
}

TEST(SessionMemory, NamesALineThatStartsNoPhase) {
  SessionFiles files = FilesOf(Sample());
  for (const char* line : {"x,SURVEY", "-1,SURVEY", "3", "1e300,SURVEY", "5,SURVEY\n3,RETURN"}) {
    files["phases.csv"] = std::string("first_sight,phase\n") + line + "\n";
    const Expected<SessionMemory> loaded = MemoryOf(files);
    ASSERT_FALSE(loaded) << line;
    EXPECT_THAT(loaded.error().text, ::testing::StartsWith("phases.csv: line "));
  }
}

TEST(FramesCsv, RefusesATextWithoutItsHeader) { EXPECT_FALSE(FramesFromCsv("1,2,3\n")); }

TEST(SessionPrior, HasTheJointCovarianceOfItsObjectsInTheirOrder) {
  SessionMemory memory;
  memory.objects.opis = {Object(1, 7, 0.98), Object(2, 3, 0.1), Object(3, 5, 0.9)};
  memory.landmarks.ids = {3, 5, 7};
  std::vector<double> lower;
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column <= row; ++column)
      lower.push_back(10.0 * row + column);
  }
  memory.landmarks.cov_W = *FromLowerTriangle(lower);
  // Landmarks 7 and 5: rows 6 to 8, then 3 to 5.
  EXPECT_THAT(LowerTriangleOf(PriorOf({}, memory).former.joint_cov_W),
              ::testing::ElementsAre(66, 76, 77, 86, 87, 88, 63, 73, 83, 33, 64, 74, 84, 43, 44, 65,
                                     75, 85, 53, 54, 55));
  memory.landmarks.ids = {3, 5, 8};
  EXPECT_TRUE(PriorOf({}, memory).former.joint_cov_W.size() == 0);
}

TEST(SessionMemory, RefusesAJointCovarianceThatIsNone) {
  SessionFiles files = FilesOf(Sample());
  files["landmarks.json"] = R"({"ids":[3],"lower":[0.04]})";
  const Expected<SessionMemory> loaded = MemoryOf(files);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().text, ::testing::HasSubstr("landmarks.json"));
}

}  // namespace
}  // namespace limpet
