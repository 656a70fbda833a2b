// SPDX-License-Identifier: MIT
// The area that `limpet check` draws.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/mission_copy.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

std::string DrawingOf(const char* mission) {
  const std::string folder = std::string(LIMPET_SOURCE_DIR) + "/missions/" + mission;
  const Checked checked = Check({folder, "--draw"});
  EXPECT_EQ(checked.exit_code, 0);
  return checked.text;
}

TEST(CheckDrawing, ShowsGroundZonesWayPointsAndStart) {
  const std::string text = DrawingOf("harbour");
  EXPECT_THAT(text, HasSubstr("no problems"));
  EXPECT_THAT(text, HasSubstr(".::::::"));
  EXPECT_THAT(text, HasSubstr("::###"));
  EXPECT_THAT(text, HasSubstr("S\n"));
  EXPECT_THAT(text, HasSubstr(" o\n"));
  EXPECT_THAT(text, HasSubstr("1565 m2 to be seen; lanes and turns of about"));
}

TEST(CheckDrawing, ShowsAnAreaThatIsNarrowerThanALetter) {
  const MissionCopy mission;
  mission.Apply({kMoos, "#define BAND",
                 "#define AREA pts={0,0:1200,0:1200,8:0,8}\n#define LONGEST 99999\n#define BAND"});
  const std::string text = Check({mission.path().string(), "--draw"}).text;
  EXPECT_THAT(text, HasSubstr("::::::::::::::::::::")) << text;
}

TEST(CheckDrawing, ShowsAZoneThatIsNarrowerThanALetter) {
  const MissionCopy mission;
  mission.Apply({kMoos, "#define BAND",
                 "#define AREA pts={0,0:800,0:800,300:0,300}\n#define LONGEST 999999\n"
                 "#define KEEP_OUT pts={100,150:700,150:700,151:100,151}\n"
                 "#define KEEP_OUT_2 pts={-900,310:900,310:900,311:-900,311}\n#define BAND"});
  const std::string text = Check({mission.path().string(), "--draw"}).text;
  EXPECT_THAT(text, HasSubstr("::####################")) << text;
}

TEST(CheckDrawing, ExplainsTheLettersThatOccur) {
  EXPECT_THAT(
      DrawingOf("harbour"),
      HasSubstr("\n: ground to be seen, . the rest of the operating region, # keep-out zone, "
                "o way point of the transit, S start and home\n"));
  EXPECT_THAT(DrawingOf("table1"), testing::Not(HasSubstr("keep-out zone,")));
}

std::string PictureOf(const char* mission) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "area.svg").string();
  Check({std::string(LIMPET_SOURCE_DIR) + "/missions/" + mission, "--figure", file});
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(CheckDrawing, ExplainsInThePictureWhatIsDrawnAndNothingElse) {
  const std::string harbour = PictureOf("harbour");
  for (const char* drawn : {"area to survey", "operating region", "keep-out zone", "transit"}) {
    EXPECT_THAT(harbour, HasSubstr(drawn));
  }
  const std::string plain = PictureOf("table1");
  EXPECT_THAT(plain, HasSubstr("operating region"));
  EXPECT_THAT(plain, testing::Not(HasSubstr("keep-out zone")));
  EXPECT_THAT(plain, testing::Not(HasSubstr("transit")));
}

TEST(CheckDrawing, LeavesJsonWhole) {
  testing::internal::CaptureStderr();
  const std::string folder = std::string(LIMPET_SOURCE_DIR) + "/missions/harbour";
  const Checked checked = Check({folder, "--json", "--draw"});
  EXPECT_TRUE(nlohmann::json::accept(checked.text)) << checked.text;
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(":::"));
}

TEST(CheckDrawing, WritesAPictureOfTheArea) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "area.svg").string();
  const std::string mission = std::string(LIMPET_SOURCE_DIR) + "/missions/harbour";
  EXPECT_THAT(Check({mission, "--figure", file}).text, testing::Not(HasSubstr(":::")));
  std::ifstream in(file);
  const std::string svg((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  EXPECT_THAT(svg, HasSubstr("What harbour surveys"));
  EXPECT_THAT(svg, HasSubstr("start and home"));
}

}  // namespace
}  // namespace limpet
