// SPDX-License-Identifier: MIT
// A pile in the middle of the basin that no chart shows: found, kept off, and surveyed around.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "tests/support/limpet_command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPiles =
    "obstacles:\n"
    "  - {name: pile, shape: column, north_m: 1, east_m: 1, radius_m: 0.4, height_m: 8}\n"
    "  - {name: chest, shape: box, north_m: -7, east_m: 7, size_m: [1, 1], height_m: 0.5}\n";

/// The basin's mission with something in it.
fs::path BasinWith(const fs::path& folder, const char* obstacles) {
  const fs::path mission = folder / "mission";
  fs::copy(fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin", mission);
  std::ofstream(mission / "scenario.yaml", std::ios::app) << obstacles;
  return mission;
}

TEST(Obstacles, ASurveyKeepsOffAPileThatNoChartShowsAndCoversTheRest) {
  TemporaryFolder folder;
  const CommandResult flown =
      RunLimpet(folder.path(),
                {"survey", BasinWith(folder.path(), kPiles).string(), "--sessions", "discovery",
                 "--seed", "4", "--set", "uSimCamera.camera=boxes", "--out", "run"});
  const nlohmann::json session =
      nlohmann::json::parse(TextOfFile(folder.path() / "run" / "report.json"))
          .at("sessions")
          .at("discovery");
  EXPECT_EQ(session.at("ended"), "home") << flown.out;
  const nlohmann::json& obstacles = session.at("obstacles");
  ASSERT_EQ(obstacles.size(), 2U);
  EXPECT_GT(obstacles[0].at("distance_m").get<double>(), 0.8) << flown.out;
  EXPECT_LT(obstacles[1].at("distance_m").get<double>(), 4.0) << "it may pass over the chest";
  EXPECT_GT(session.at("covered").get<double>(), 0.95) << flown.out;
  EXPECT_NE(flown.out.find("obstacles passed at: pile"), std::string::npos) << flown.out;
}

/// A box of 20 m2, 5 % of the area, that nearly reaches the surface.
constexpr const char* kWreck =
    "obstacles:\n"
    "  - {name: wreck, shape: box, north_m: 0.5, east_m: 1, size_m: [4, 5], height_m: 5.5}\n";

TEST(Obstacles, ASurveyAroundAWreckEndsByItsOwnJudgement) {
  TemporaryFolder folder;
  const CommandResult flown =
      RunLimpet(folder.path(), {"survey", BasinWith(folder.path(), kWreck).string(), "--sessions",
                                "discovery", "--seed", "4", "--set", "uSimCamera.camera=boxes",
                                "--set", "pHelm.obstacle_clearance_m=1.1", "--out", "run"});
  const nlohmann::json session =
      nlohmann::json::parse(TextOfFile(folder.path() / "run" / "report.json"))
          .at("sessions")
          .at("discovery");
  EXPECT_EQ(session.at("ended"), "home") << flown.out;
  EXPECT_GT(session.at("obstacles")[0].at("distance_m").get<double>(), 0.6) << flown.out;
  EXPECT_GT(session.at("detected_band").get<double>(), 0.95) << flown.out;
  const nlohmann::json& unseen = session.at("unseen_share");
  EXPECT_GE(unseen.at("band_by_reason").at("obstacle").get<double>(), 0.045);
  EXPECT_NE(flown.out.find("under or behind obstacles"), std::string::npos) << flown.out;
}

TEST(Obstacles, AWrongOneIsRefusedBeforeTheDiveWithItsLine) {
  TemporaryFolder folder;
  const fs::path mission =
      BasinWith(folder.path(), "obstacles:\n  - {name: pile, shape: colum, north_m: 1}\n");
  const CommandResult checked = RunLimpet(folder.path(), {"check", mission.string()});
  EXPECT_EQ(checked.exit_code, kUsage) << checked.out;
  EXPECT_NE((checked.out + checked.err).find("obstacles[0].shape: `colum` is not allowed"),
            std::string::npos)
      << checked.out << checked.err;
}

}  // namespace
}  // namespace limpet
