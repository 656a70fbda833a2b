// SPDX-License-Identifier: MIT
// The area that `limpet check` draws.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/cli/mission_copy.hpp"

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
