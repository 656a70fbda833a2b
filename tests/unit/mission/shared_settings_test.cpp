// SPDX-License-Identifier: MIT
#include "limpet/mission/shared_settings.hpp"

#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

ConfigBlock Block(const std::string& name) { return {.name = name, .where = {}, .entries = {}}; }

TEST(SharedSettings, EachParameterIsOneGlobals) {
  EXPECT_EQ(GlobalFor("pSurvey", "altitude_m"), "survey_altitude_m");
  EXPECT_EQ(GlobalFor("pNav", "opi_radius_m"), "object_radius_m");
  EXPECT_EQ(GlobalFor("pNav", "altitude_m"), "");
  std::set<std::pair<std::string, std::string>> takers;
  for (const SharedSetting& setting : SharedSettings()) {
    for (const SharedSetting::Taker& taker : setting.takers)
      EXPECT_TRUE(takers.insert({taker.owner, taker.key}).second) << taker.key;
  }
}

TEST(SharedSettings, ReachEveryBehaviorThatTakesThem) {
  const std::vector<ConfigEntry> globals{{"Settled_Looks", "3", {.file = "m.moos", .line = 7}},
                                         {"survey_altitude_m", "4", {}}};
  std::vector<ConfigBlock> blocks{Block("BHV_RevisitOpi"), Block("BHV_HoldAltitude"),
                                  Block("BHV_OpRegion")};
  TakeGlobals(globals, blocks);
  ASSERT_EQ(blocks[0].entries.size(), 1U);
  EXPECT_EQ(blocks[0].entries[0].key, "settled_looks");
  EXPECT_EQ(blocks[0].entries[0].where.line, 7);
  EXPECT_EQ(blocks[1].Find("altitude_m")->value, "4");
  EXPECT_TRUE(blocks[2].entries.empty());
  TakeGlobals(globals, blocks);
  EXPECT_EQ(blocks[0].entries.size(), 1U) << "what it has it does not take again";
}

}  // namespace
}  // namespace limpet
