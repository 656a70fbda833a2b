// SPDX-License-Identifier: MIT
// What `limpet tune --resume` may be told again.
#include "apps/limpet/verbs/tune_resume.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/tune_form.hpp"
#include "limpet/console/command_output.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using Words = std::vector<std::string>;

const Words kAsked{"small",
                   "--vary=cover.pwt=0:1",
                   "--vary",
                   "hold.pwt=1:2",
                   "--runs",
                   "3",
                   "--objective=sessions.discovery.path_m"};

Words Resumed(Words words) {
  words.insert(words.end(), {"--resume", "out"});
  return ResumedWords(kAsked, ReadArguments(TuneForm(), words));
}

std::string Refused(const Words& words) {
  try {
    static_cast<void>(Resumed(words));
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(ResumedSearch, TakesTheWordsItWasAskedForWith) {
  Words whole = kAsked;
  whole.emplace_back("--out=out");
  EXPECT_EQ(Resumed({}), whole);
  EXPECT_EQ(Resumed(kAsked), whole);
  EXPECT_EQ(Resumed({"./small/", "--vary", "cover.pwt=0:1", "--runs=3"}), whole);
  EXPECT_EQ(Resumed({"--method=grid"}), whole) << "as it is where it is not said";
}

TEST(ResumedSearch, TakesOthersThatSayHowItIsRunHere) {
  EXPECT_THAT(Resumed({"--jobs=7", "--json"}), IsSupersetOf({"--jobs=7", "--json"}));
}

TEST(ResumedSearch, RefusesOthersAndNamesBoth) {
  EXPECT_THAT(Refused({"large"}), HasSubstr("with the mission small, not with large"));
  EXPECT_THAT(Refused({"--runs=5"}), HasSubstr("with --runs=3, not with --runs=5"));
  EXPECT_THAT(Refused({"--vary=cover.pwt=0:2"}),
              HasSubstr("with --vary=cover.pwt=0:1 --vary=hold.pwt=1:2, not with "
                        "--vary=cover.pwt=0:2"));
  EXPECT_THAT(Refused({"--maximise"}), HasSubstr("without --maximise, not with --maximise"));
  EXPECT_THAT(Refused({"--method=bayes"}), HasSubstr("with --method=grid"));
}

}  // namespace
}  // namespace limpet
