// SPDX-License-Identifier: MIT
// The list that `limpet describe` prints of made-up warnings and events.
#include "limpet/describe/warning_list.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/describe/markdown_rows.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

WarningList MadeWarnings() {
  return {.warnings = {{.id = "LEAK",
                        .facts = {.severity = Severity::kAlarm,
                                  .raised_by = {"pHull", "pKeel"},
                                  .meaning = "Water | comes in.",
                                  .action = "Pump.",
                                  .clears = "When it is dry."}},
                       {.id = "ODD_<PART>",
                        .facts = {.severity = Severity::kNote,
                                  .raised_by = {},
                                  .meaning = "It is odd.",
                                  .action = "Wonder.",
                                  .clears = "Never."}}},
          .events = {
              {"STRUCK",
               {.severity = Severity::kWarning, .reported_by = {"pHull"}, .meaning = "A blow."}}}};
}

TEST(WarningListText, SaysWhoWarnsHowGravelyWhatToDoAndWhenItIsOver) {
  const std::string text = PlainText(MadeWarnings());
  EXPECT_THAT(text, HasSubstr("LEAK: alarm, raised by pHull, pKeel\n"));
  EXPECT_THAT(text, HasSubstr("  meaning  Water | comes in.\n  to do    Pump.\n"
                              "  clears   When it is dry.\n"));
  EXPECT_THAT(text, HasSubstr("ODD_<PART>: note, raised by every app\n"));
  EXPECT_THAT(text, HasSubstr("STRUCK: event, warning, reported by pHull\n  meaning  A blow.\n"));
}

TEST(WarningListText, JsonAndMarkdownHoldEveryWarningAndEvent) {
  const auto said = nlohmann::json::parse(Json(MadeWarnings()));
  ASSERT_EQ(said.at("warnings").size(), 2U);
  EXPECT_EQ(said.at("warnings").at(0).at("severity"), "alarm");
  EXPECT_EQ(said.at("warnings").at(0).at("action"), "Pump.");
  EXPECT_EQ(said.at("events").at(0).at("id"), "STRUCK");
  const auto rows = RowsOf(Markdown(MadeWarnings()));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0], ElementsAre("`LEAK`", "alarm", "pHull, pKeel", "Water | comes in.", "Pump.",
                                   "When it is dry."));
  EXPECT_THAT(rows[2], ElementsAre("`STRUCK`", "warning", "pHull", "A blow."));
}

}  // namespace
}  // namespace limpet
