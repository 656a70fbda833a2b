// SPDX-License-Identifier: MIT
// The list of parameters that `limpet describe` prints, of made-up apps: nothing that is
// declared may be missing from any of the three forms, and no text may break one.
#include "limpet/describe/parameter_list.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/describe/markdown_rows.hpp"

namespace limpet {
namespace {

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

}  // namespace
}  // namespace limpet
