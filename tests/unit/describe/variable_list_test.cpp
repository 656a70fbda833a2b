// SPDX-License-Identifier: MIT
// The list that `limpet describe` prints of a made-up variable.
#include "limpet/describe/variable_list.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/describe/markdown_rows.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Variable MadeVariable() {
  return {.name = "MADE_STATE",
          .meaning = "how it | stands",
          .type = "string, key=value",
          .fields = {"north", "east"},
          .facts = {.unit = "m", .frame = "NED", .rate = "10 Hz", .writers = {"pA", "pB"}}};
}

TEST(VariableList, SaysWhatAVariableIsAndWhoReadsIt) {
  const Readers readers{{"MADE_STATE", {"pReader", "pOther"}}};
  const std::string text = PlainText(MadeVariable(), readers);
  EXPECT_THAT(text, HasSubstr("MADE_STATE: how it | stands\n"));
  for (const char* part :
       {"string, key=value: north, east", "m", "NED", "10 Hz", "pA, pB", "pOther, pReader"}) {
    EXPECT_THAT(text, HasSubstr(std::string(" ") + part + "\n"));
  }
  EXPECT_THAT(PlainText(MadeVariable(), {}), Not(HasSubstr("readers")));
}

TEST(VariableList, JsonAndMarkdownSayTheSame) {
  const Readers readers{{"MADE_STATE", {"pReader"}}, {"*", {"pLog"}}};
  const auto list = nlohmann::json::parse(Json({MadeVariable()}, readers));
  EXPECT_EQ(list.at(0).at("fields").size(), 2U);
  EXPECT_EQ(list.at(0).at("frame"), "NED");
  EXPECT_EQ(list.at(0).at("readers"), nlohmann::json({"pReader"}));
  const std::string page = Markdown({MadeVariable()}, readers);
  const auto rows = RowsOf(page);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_THAT(rows[0],
              ElementsAre("`MADE_STATE`", "how it | stands", "string, key=value: north, east", "m",
                          "NED", "10 Hz", "pA, pB", "pReader"));
  EXPECT_THAT(page, HasSubstr("Apps that hear everything: pLog."));
}

}  // namespace
}  // namespace limpet
