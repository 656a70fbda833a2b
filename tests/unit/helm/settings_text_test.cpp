// SPDX-License-Identifier: MIT
#include "limpet/helm/settings_text.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SettingsText, HasWhatTheBlockSaysElseTheDefaultsAndLeavesOutWhatIsNoSetting) {
  std::vector<ParamSpec> specs(6);
  specs[0].name = "points", specs[0].aliases = {"polygon"};
  specs[1].name = "speed", specs[1].example = {"1"};
  specs[2].name = "lead";
  specs[3].name = "wptflag", specs[3].example = {"A = 1"}, specs[3].is_repeatable = true;
  specs[4].name = "patience", specs[4].example = {"2"}, specs[4].is_without_effect = true;
  specs[5].name = "radius", specs[5].example = {"3"};
  const ConfigBlock block{
      .name = "BHV_Waypoint",
      .where = {},
      .entries = {{"Polygon", "0,0:10,0", {}}, {"SPEED", "2.5", {}}, {"speed", "2", {}}}};
  EXPECT_EQ(SettingsText(block, "survey", specs),
            "type=BHV_Waypoint,name=survey,points=\"0,0:10,0\",speed=2,radius=3");
}

}  // namespace
}  // namespace limpet
