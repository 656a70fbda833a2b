// SPDX-License-Identifier: MIT
#include "limpet/runs/run_settings.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "estimation/mapping/map_params.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {
namespace {

TEST(RunSettings, TakesTheVehicleToMapFromAsHighAsPMapDoesWhereTheMissionSaysNothing) {
  EXPECT_EQ(ReportSettings{}.highest_view_m, MapParams{}.highest_view.value());
}

TEST(RunSettings, TakesTheObjectsToBeAsLargeAsTheMissionSaysWhateverIsThere) {
  const std::filesystem::path basin =
      std::filesystem::path(LIMPET_SOURCE_DIR) / "missions" / "basin" / "mission.moos";
  const MissionFile mission = LoadMission(basin);  // it looks for objects of 0.3 m
  Scenario scenario;
  EXPECT_EQ(SettingsOf(mission, scenario).object_radius_m, 0.3);
  scenario.opis.resize(1);
  scenario.opis.front().radius_m = 0.8;
  EXPECT_EQ(SettingsOf(mission, scenario).object_radius_m, 0.3);
}

}  // namespace
}  // namespace limpet
