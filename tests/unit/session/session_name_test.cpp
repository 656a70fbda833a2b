// SPDX-License-Identifier: MIT
#include "limpet/session/session_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(SessionName, TakesWordsThatCanOnlyNameAFolderInTheRun) {
  for (const char* name : {"discovery", "change", "2026-05-14_b", "x"}) {
    EXPECT_FALSE(SessionNameProblem(name)) << name;
  }
}

TEST(SessionName, RefusesWhateverLeavesTheRunOrIsItsOwn) {
  for (const char* name : {"", ".", "..", "../x", "../../x", "/tmp/x", "a/b", "a b", "Change",
                           "a.b", "~", "caf\xC3\xA9", "figures", "each"}) {
    EXPECT_TRUE(SessionNameProblem(name)) << name;
  }
  EXPECT_TRUE(SessionNameProblem(std::string(65, 'a')));
  EXPECT_TRUE(SessionNameProblem(std::string_view("a\0b", 3)));
}

TEST(SessionName, ShowsNothingThatATerminalObeys) {
  const auto problem = SessionNameProblem("a\033[2Jb");
  ASSERT_TRUE(problem);
  EXPECT_THAT(problem->text, Not(HasSubstr("\033")));
}

TEST(SessionList, RefusesNoneTwiceAndUnknown) {
  const std::vector<std::string> known{"change", "discovery", "third"};
  EXPECT_FALSE(SessionListProblem({"discovery", "change", "third"}, known));
  EXPECT_THAT(SessionListProblem({}, known)->text, HasSubstr("no session"));
  EXPECT_THAT(SessionListProblem({"change", "change"}, known)->text, HasSubstr("comes twice"));
  EXPECT_THAT(SessionListProblem({"thrid"}, known)->text, HasSubstr("did you mean `third`"));
}

TEST(SessionList, TakesAnyNameWhereNoScenarioListsThem) {
  EXPECT_FALSE(SessionListProblem({"monday", "tuesday"}, {}));
  EXPECT_TRUE(SessionListProblem({"monday", "../tuesday"}, {}));
}

}  // namespace
}  // namespace limpet
