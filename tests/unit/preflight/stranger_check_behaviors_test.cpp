// SPDX-License-Identifier: MIT
// What `limpet check` makes of the behaviors of a mission whose stock helm's place ours takes.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "tests/support/mission_copy.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

class CheckOfStockBehaviors : public ::testing::Test {
 protected:
  /// Checks the mission, or its behavior file alone.
  [[nodiscard]] Checked Run(const std::string& behaviors, const std::string& named) const {
    std::ofstream(folder_.path() / "a.bhv") << behaviors;
    std::ofstream(folder_.path() / "a.moos")
        << "ServerPort = 9000\nCommunity = alpha\nProcessConfig = ANTLER\n{\n  Run = MOOSDB\n"
           "  Run = pHelmIvP\n}\nProcessConfig = pHelmIvP\n{\n  behaviors = a.bhv\n"
           "  domain = course:0:359:360\n  domain = speed:0:4:41\n}\n";
    return Check({(folder_.path() / named).string()});
  }
  TemporaryFolder folder_;
};

TEST_F(CheckOfStockBehaviors, RefusesAKeyThatABehaviorOfBothHelmsLacks) {
  for (const char* named : {"a.moos", "a.bhv"}) {
    const Checked slip =
        Run("Behavior = BHV_Waypoint\n{\n  points = 0,9\n  speeed = 2\n}\n", named);
    EXPECT_EQ(slip.exit_code, kUsage) << slip.text;
    EXPECT_THAT(slip.text, HasSubstr("a.bhv:4: speeed: unknown key in BHV_Waypoint; did you mean "
                                     "`speed`?"));
  }
}

TEST_F(CheckOfStockBehaviors, RefusesANameThatNoHelmTakes) {
  for (const char* named : {"a.moos", "a.bhv"}) {
    const Checked slip = Run("Behavior = BHV_waypoint\n{\n  points = 0,9\n}\n", named);
    EXPECT_EQ(slip.exit_code, kUsage) << slip.text;
    EXPECT_THAT(slip.text, HasSubstr("it is called `BHV_Waypoint`"));
  }
}

TEST_F(CheckOfStockBehaviors, TakesWhatIsRightOrOnlyTheirsOrAMacroStill) {
  for (const char* behaviors :
       {"Behavior = BHV_Waypoint\n{\n  points = 0,9\n  speed = 2\n}\n",
        "Behavior = BHV_Trail\n{\n  name = t\n  any_key = 2\n}\n",
        "Behavior = BHV_Waypoint\n{\n  points = 0,9\n  speed = $(SPEED)\n}\n"}) {
    for (const char* named : {"a.moos", "a.bhv"}) {
      const Checked checked = Run(behaviors, named);
      EXPECT_EQ(checked.exit_code, kOk) << checked.text;
    }
  }
}

}  // namespace
}  // namespace limpet
