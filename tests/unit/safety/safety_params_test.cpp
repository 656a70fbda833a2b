// SPDX-License-Identifier: MIT
#include "limpet/safety/safety_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;

ConfigBlock BlockWith(const std::string& key, const std::string& value) {
  return {.name = "pSafety",
          .where = {},
          .entries = {{.key = key, .value = value, .where = {.file = "m.moos", .line = 7}}}};
}

std::size_t IndexOf(SafetyRuleId id) { return static_cast<std::size_t>(id); }

TEST(SafetyParams, AreTheTablesUnlessAMissionSaysOtherwise) {
  const SafetyParams params = ReadParams<SafetyParams>(BlockWith("depth_limit_m", "30"));
  EXPECT_DOUBLE_EQ(params.settings.limits[IndexOf(SafetyRuleId::kDepthOverLimit)], 30.0);
  EXPECT_DOUBLE_EQ(params.settings.limits[IndexOf(SafetyRuleId::kAltitudeLow)], 0.8);
  EXPECT_EQ(ReadParams<SafetyParams>(BlockWith("leak_hold_s", "4"))
                .settings.holds[IndexOf(SafetyRuleId::kLeak)],
            Seconds(4.0));
}

TEST(SafetyParams, RefuseALimitThatIsNoneByFileLineAndRange) {
  for (const auto& [key, value, said] :
       {std::tuple{"depth_limit_m", "-1", "m.moos:7: depth_limit_m: `-1` is not allowed"},
        {"depth_limit", "30", "depth_limit_m"},
        {"leak_limit", "1", "m.moos:7"}}) {
    try {
      static_cast<void>(ReadParams<SafetyParams>(BlockWith(key, value)));
      ADD_FAILURE() << key;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr(said));
    }
  }
}

TEST(SafetyParams, SayOfALimitOnWhichSideItTripsAndInWhichUnit) {
  SafetyParams params;
  std::string depth, battery;
  for (const ParamSpec& spec : DescribeParams(params)) {
    if (spec.name == "depth_limit_m") depth = spec.help;
    if (spec.name == "battery_low_percent") battery = spec.help;
  }
  EXPECT_THAT(depth, HasSubstr("Rule depth_over_limit, above the limit [m]"));
  EXPECT_THAT(battery, HasSubstr("Rule battery_low, below the limit [%]"));
}

TEST(SafetyParams, HaveNoWaitForARuleThatTripsAtOnce) {
  EXPECT_EQ(HoldKeyOf(SafetyRuleOf(SafetyRuleId::kLeak)), "leak_hold_s");
  EXPECT_EQ(HoldKeyOf(SafetyRuleOf(SafetyRuleId::kDvlLost)), "");
}

TEST(SafetyParams, SwitchRulesOffByName) {
  SafetyParams params;
  params.off = {"leak", "dvl_lost"};
  const SafetySettings applied = params.Applied("pSafety");
  EXPECT_TRUE(applied.is_off[IndexOf(SafetyRuleId::kLeak)]);
  EXPECT_TRUE(applied.is_off[IndexOf(SafetyRuleId::kDvlLost)]);
  EXPECT_FALSE(applied.is_off[IndexOf(SafetyRuleId::kDvlSilent)]);
}

}  // namespace
}  // namespace limpet
