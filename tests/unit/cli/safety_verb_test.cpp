// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/safety.hpp"
#include "tests/support/mission_copy.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

std::string Printed(std::vector<std::string> args, int expected) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(RunSafety(args), expected);
  return testing::internal::GetCapturedStdout();
}

TEST(SafetyVerb, PrintsTheRulesWithAMissionsLimits) {
  const std::string mission = std::string(LIMPET_SOURCE_DIR) + "/missions/table1";
  EXPECT_THAT(Printed({"list"}, 0), HasSubstr("depth_over_limit       above 100 m"));
  EXPECT_THAT(Printed({"list", mission}, 0), HasSubstr("leak"));
}

TEST(SafetyVerb, RefusesWhatItCannotDo) {
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{"lift"}, {"list", "no/such/mission"}}) {
    EXPECT_THROW(static_cast<void>(RunSafety(args)), UsageError);
  }
}

TEST(SafetyVerb, SaysThatNoFaultHasTheNameThatIsAskedFor) {
  const std::string mission = std::string(LIMPET_SOURCE_DIR) + "/missions/table1";
  try {
    static_cast<void>(RunSafety(std::vector<std::string>{"test", mission, "--only", "leek"}));
    FAIL() << "all is well with no flight at all";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--only leek: no fault has it in its name; did you mean "
                                        "`leak`?"));
  }
}

TEST(SafetyVerb, TriesNoMissionWhoseScenarioHasFaultsOfItsOwn) {
  const MissionCopy mission;
  mission.Apply({"scenario.yaml", "seabed:", "faults: [{what: leak, at_s: 3}]\nseabed:"});
  EXPECT_THROW(
      static_cast<void>(RunSafety(std::vector{std::string("test"), mission.path().string()})),
      UsageError);
}

}  // namespace
}  // namespace limpet
