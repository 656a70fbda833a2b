// SPDX-License-Identifier: MIT
// The first minutes of missions/square_km as its user flies it.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "tests/support/limpet_command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

TEST(LargeArea, TheFirstLanesOfASquareKilometreAreFlownAndItComesHome) {
  TemporaryFolder folder;
  const fs::path mission = fs::path(LIMPET_SOURCE_DIR) / "missions" / "square_km";
  const CommandResult flown =
      RunLimpet(folder.path(),
                {"survey", mission.string(), "--sessions", "discovery", "--seed", "3", "--set",
                 "pSurvey.coverage_target=0.002", "--set", "pSurvey.align_s=30", "--out", "run"});
  EXPECT_EQ(flown.exit_code, kOk) << flown.err << flown.out;
  const nlohmann::json session =
      nlohmann::json::parse(TextOfFile(folder.path() / "run" / "report.json"))
          .at("sessions")
          .at("discovery");
  EXPECT_EQ(session.at("ended"), "home") << flown.out;
  EXPECT_GT(session.at("covered").get<double>(), 0.002);
  EXPECT_LT(session.at("path_m").get<double>(), 500.0) << flown.out;
}

}  // namespace
}  // namespace limpet
