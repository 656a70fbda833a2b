// SPDX-License-Identifier: MIT
// The lists that `limpet describe` prints, of made-up apps, variables and warnings: nothing that is
// declared may be missing from any of the three forms, and no text may break one.
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/core/config.hpp"
#include "limpet/core/random.hpp"
#include "limpet/describe/markdown_cell.hpp"
#include "limpet/describe/parameter_list.hpp"
#include "limpet/describe/variable_list.hpp"
#include "limpet/describe/warning_list.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

struct DescribedParams {
  Meters depth{5.0};
  Radians course = Radians::FromTextUnit(90.0);
  int looks = 3;
  bool is_loud = true;
  std::string planner = "limpet";
  std::vector<std::string> lines{"a", "b"};
  double share = 0.25;
  template <class V>
  void Describe(V& visit) {
    visit.Required("depth_m", depth, "Depth to keep", InRange(Meters(1.0), Meters(60.0)));
    visit("course_deg", course, "Course | to steer", AtLeast(Radians::FromTextUnit(0.0)));
    visit("looks", looks, "Looks wanted", InRange(1, 9));
    visit("is_loud", is_loud, "Says so aloud");
    visit.Choice("planner", planner, "Who decides", {"limpet", "paper"});
    visit("line", lines, "May be said often");
    visit("share", share, "A share\nof two lines");
  }
};

ParameterOwner MadeOwner(const std::string& name, ParameterOwner::Kind kind) {
  DescribedParams params;
  ParameterOwner owner{
      .name = name, .kind = kind, .tick_hz = {}, .parameters = DescribeParams(params)};
  if (kind == ParameterOwner::Kind::kApp) owner.tick_hz = 4.0;
  return owner;
}

const ParamSpec& SpecOf(const ParameterOwner& owner, const std::string& name) {
  return *std::ranges::find(owner.parameters, name, &ParamSpec::name);
}

TEST(ParameterList, ShowsEveryParameterWithUnitDefaultRangeAndMeaning) {
  const ParameterOwner owner = MadeOwner("pMade", ParameterOwner::Kind::kBehavior);
  const std::string text = PlainText(owner);
  EXPECT_THAT(text, HasSubstr("pMade: behavior\n"));
  EXPECT_THAT(text,
              HasSubstr("depth_m: required\n      Depth to keep\n      allowed: 1 to 60 m\n"));
  EXPECT_THAT(text, HasSubstr("course_deg = 90 deg\n"));
  EXPECT_THAT(text, HasSubstr("allowed: at least 0 deg\n"));
  EXPECT_THAT(text, HasSubstr("looks = 3\n      Looks wanted\n      allowed: 1 to 9\n"));
  EXPECT_THAT(text,
              HasSubstr("is_loud = true\n      Says so aloud\n      allowed: true or false\n"));
  EXPECT_THAT(text, HasSubstr("planner = limpet\n"));
  EXPECT_THAT(text, HasSubstr("paper"));
  EXPECT_THAT(text, HasSubstr("line = a, b\n"));
  EXPECT_THAT(text, HasSubstr("(may repeat)"));
}

TEST(ParameterList, JsonHoldsWhatWasDeclaredFieldByField) {
  const ParameterOwner owner = MadeOwner("pMade", ParameterOwner::Kind::kBehavior);
  const auto list = nlohmann::json::parse(Json(std::vector<ParameterOwner>{owner}));
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].at("kind"), "behavior");
  EXPECT_FALSE(list[0].contains("tick_hz"));
  ASSERT_EQ(list[0].at("parameters").size(), owner.parameters.size());
  for (const auto& said : list[0].at("parameters")) {
    const ParamSpec& spec = SpecOf(owner, said.at("name"));
    EXPECT_EQ(said.at("unit"), spec.unit);
    EXPECT_EQ(said.at("allowed"), spec.allowed);
    EXPECT_EQ(said.at("meaning"), spec.help);
    EXPECT_EQ(said.at("required"), spec.is_required);
    EXPECT_EQ(said.at("default").is_null(), spec.is_required);
    EXPECT_EQ(said.at("repeatable"), spec.is_repeatable);
    EXPECT_EQ(said.at("example"), spec.example);
  }
}

/// Cells of a row of a Markdown table, `\|` undone.
std::vector<std::string> MarkdownCells(const std::string& row) {
  std::vector<std::string> cells(1);
  for (std::size_t i = 1; i + 1 < row.size(); ++i) {
    if (row[i] == '\\' && row[i + 1] == '|') {
      cells.back() += row[++i];
    } else if (row[i] == '|') {
      cells.emplace_back();
    } else {
      cells.back() += row[i];
    }
  }
  for (std::string& cell : cells)
    cell = std::string(Trim(cell));
  return cells;
}

std::vector<std::vector<std::string>> RowsOf(const std::string& page) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : Split(page, '\n')) {
    if (line.starts_with("| `")) rows.push_back(MarkdownCells(line));
  }
  return rows;
}

TEST(ParameterList, MarkdownHasARowOfFourCellsForEachParameter) {
  const ParameterOwner owner = MadeOwner("BHV_Made", ParameterOwner::Kind::kBehavior);
  const auto rows = RowsOf(Markdown(std::vector<ParameterOwner>{owner}));
  ASSERT_EQ(rows.size(), owner.parameters.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 4U) << rows[i][0];
    EXPECT_EQ(rows[i][0], "`" + owner.parameters[i].name + "`");
  }
  EXPECT_EQ(rows[0][1], "required");
  EXPECT_EQ(rows[1][1], "90 deg");
  EXPECT_EQ(rows[1][3], "Course | to steer") << "a bar in a text ends no cell";
  EXPECT_EQ(rows[6][3], "A share of two lines");
}

TEST(ParameterList, MarkdownKeepsAppsBehaviorsAndDetectorsApart) {
  const std::string page = Markdown({MadeOwner("pMade", ParameterOwner::Kind::kApp),
                                     MadeOwner("BHV_Made", ParameterOwner::Kind::kBehavior)});
  const std::size_t apps = page.find("\n## Apps\n"), app = page.find("\n### pMade\n");
  const std::size_t behaviors = page.find("\n## Behaviors\n"), behavior = page.find("### BHV_Made");
  EXPECT_LT(apps, app);
  EXPECT_LT(app, behaviors);
  EXPECT_LT(behaviors, behavior);
  EXPECT_THAT(page, Not(HasSubstr("## Detectors"))) << "there is none";
  EXPECT_THAT(page, HasSubstr("Ticks at 4 Hz unless AppTick says otherwise."));
}

TEST(ParameterList, SaysSoOfAnOwnerWithoutParameters) {
  const ParameterOwner bare{
      .name = "BHV_Bare", .kind = ParameterOwner::Kind::kBehavior, .tick_hz = {}, .parameters = {}};
  EXPECT_THAT(Markdown(std::vector<ParameterOwner>{bare}),
              HasSubstr("### BHV_Bare\n\nNo parameters of its own.\n"));
}

TEST(MarkdownCell, StaysOneCellWhateverItHolds) {
  Random random(1, "cells");
  for (int run = 0; run < 500; ++run) {
    std::string text;
    for (std::uint64_t i = random.Index(20); i > 0; --i)
      text += "ab|\n "[random.Index(5)];
    const std::string row = "| " + MarkdownCell(text) + " | end |";
    EXPECT_EQ(row.find('\n'), std::string::npos);
    const auto cells = MarkdownCells(row);
    ASSERT_EQ(cells.size(), 2U) << text;
    std::ranges::replace(text, '\n', ' ');
    EXPECT_EQ(cells[0], Trim(text));
  }
}

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
