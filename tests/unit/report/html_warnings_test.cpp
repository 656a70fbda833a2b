// SPDX-License-Identifier: MIT
#include "limpet/report/html_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;

const WarningId kFlooded = DeclareWarning("FLOODED", {.severity = Severity::kAlarm,
                                                      .raised_by = {"pHull"},
                                                      .meaning = "There is water in the hull.",
                                                      .action = "Recover the vehicle.",
                                                      .clears = "When it is dry."});

/// A record of a session that begins at 1000 s.
WarningRecord Raised(const std::string& id, Severity severity, double from,
                     std::optional<double> to) {
  return {.app = "pHull",
          .id = id,
          .severity = severity,
          .text = "since " + std::to_string(static_cast<int>(from)) + " s",
          .from = Seconds(1000.0 + from),
          .to = to ? std::optional(Seconds(1000.0 + *to)) : std::nullopt};
}

std::string Table(const std::vector<WarningRecord>& warnings) {
  return WarningsTable(warnings, Seconds(1000.0), Seconds(1100.0));
}

TEST(WarningsTable, HasOneRowForAWarningHoweverOftenItWasRaised) {
  const std::string page = Table({Raised("DAMP", Severity::kWarning, 10.0, 15.0),
                                  Raised("DAMP", Severity::kWarning, 40.0, 47.0)});
  EXPECT_THAT(page, HasSubstr("<td>pHull DAMP</td><td class=\"left\"><span "
                              "class=\"warning\">warning</span></td><td>2</td><td>10</td>"
                              "<td>47</td><td>12</td><td class=\"left text\">since 40 s</td>"));
}

TEST(WarningsTable, SaysWhatStoodAtTheEnd) {
  EXPECT_THAT(Table({Raised("DAMP", Severity::kNote, 60.0, {})}),
              HasSubstr("<td>1</td><td>60</td><td>stands</td><td>40</td>"));
}

TEST(WarningsTable, BeginsWithTheGravest) {
  const std::string page = Table({Raised("DAMP", Severity::kNote, 10.0, 15.0),
                                  Raised(kFlooded.name(), kFlooded.severity(), 50.0, {})});
  EXPECT_LT(page.find("FLOODED"), page.find("DAMP"));
}

TEST(WarningsTable, SaysWhatADeclaredWarningMeansAndWhatToDo) {
  EXPECT_THAT(Table({Raised(kFlooded.name(), kFlooded.severity(), 50.0, {})}),
              HasSubstr("There is water in the hull. Recover the vehicle."));
}

TEST(WarningsTable, ATextOfAForeignAppIsNoMarkup) {
  WarningRecord warning = Raised("DAMP", Severity::kNote, 10.0, 15.0);
  warning.text = "<script>";
  EXPECT_THAT(Table({warning}), HasSubstr("&lt;script&gt;"));
}

TEST(WarningsTable, SaysSoWhenNothingWasWarnedOf) {
  EXPECT_THAT(Table({}), HasSubstr("No app warned of anything."));
}

}  // namespace
}  // namespace limpet
