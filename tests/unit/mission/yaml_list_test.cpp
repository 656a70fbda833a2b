// SPDX-License-Identifier: MIT
// What the lists of scenario.yaml have in common, by the complaints about them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mission/scenario_errors.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

TEST(YamlList, IsAListAndNothingElse) {
  for (const std::string key : {"opis", "obstacles", "faults"}) {
    EXPECT_THAT(ScenarioErrorsOf(key + ": none\n"),
                HasSubstr("s.yaml:1: " + key + ": `none` is not allowed; allowed: a list"));
    EXPECT_EQ(ScenarioErrorsOf(key + ":\n"), "");
  }
}

TEST(YamlList, ItsElementsHaveNames) {
  for (const std::string key : {"opis", "obstacles"}) {
    EXPECT_THAT(ScenarioErrorsOf(key + ":\n  - {name: [a, b]}\n"),
                HasSubstr("s.yaml:2: " + key + "[0].name: a list of 2 is no name"));
  }
}

TEST(YamlList, NoTwoElementsHaveOneName) {
  EXPECT_THAT(ScenarioErrorsOf("opis:\n  - {name: A}\n  - {name: A}\n"),
              HasSubstr("s.yaml:3: opis[1].name: `A` is the name of two objects"));
  EXPECT_THAT(ScenarioErrorsOf("obstacles:\n  - {name: A}\n  - {name: A}\n"),
              HasSubstr("s.yaml:3: obstacles[1].name: `A` is the name of two obstacles"));
}

}  // namespace
}  // namespace limpet
