// SPDX-License-Identifier: MIT
#include "limpet/report/html_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The page's words and the terminal's are one: nothing was said, so nothing is wrong.
TEST(HtmlPage, CallsAnUndecidedChangeOpenNotWrong) {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  RunScore run = ScoreRun({RecordOf(session)}, Table1Scenario(), Table1Settings());
  std::vector<ChangeScore>& changes = run.sessions[0].opis.changes;
  for (ChangeScore& change : changes)
    change.decided = *change.expected;
  changes.at(0).decided = Status::kUncertain;
  changes.at(0).posterior =
      StatusPosterior{.confirmed = 0.72, .removed = 0.25, .appeared = 0.0, .nothing = 0.03};
  changes.at(1).decided = Status::kNotInspected;
  const std::string page = HtmlPage(run, {});
  EXPECT_THAT(page, HasSubstr(">open: confirmed or removed</span>"));
  EXPECT_THAT(page, HasSubstr(">open</span>"));
  EXPECT_THAT(page, Not(HasSubstr(" wrong</span>")));
  changes.at(3).decided = Status::kRemoved;  // it is there
  EXPECT_THAT(HtmlPage(run, {}), HasSubstr(" wrong</span>"));
}

}  // namespace
}  // namespace limpet
