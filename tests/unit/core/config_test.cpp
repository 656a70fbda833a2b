// SPDX-License-Identifier: MIT
#include "limpet/core/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/number_text.hpp"
#include "limpet/core/params.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ConfigProblem, NamesFileLineAndKey) {
  EXPECT_EQ((ConfigProblem{{"m.moos", 12}, "AppTick", "too fast"}).Format(),
            "m.moos:12: AppTick: too fast");
  EXPECT_EQ((ConfigProblem{{"m.moos", 0}, "", "cannot be read"}).Format(),
            "m.moos: cannot be read");
}

TEST(ConfigBlock, FindsTheFirstEntryWithoutCase) {
  const ConfigBlock block{.name = "b", .where = {}, .entries = {{"A", "1", {}}, {"a", "2", {}}}};
  ASSERT_NE(block.Find("a"), nullptr);
  EXPECT_EQ(block.Find("a")->value, "1");
  EXPECT_EQ(block.Find("b"), nullptr);
}

TEST(NearestWord, FindsASlipOfThePenAndNothingElse) {
  const std::vector<std::string> words{"altitude_m", "speed_mps", "AppTick"};
  EXPECT_EQ(NearestWord("altitde_m", words), "altitude_m");
  EXPECT_EQ(NearestWord("apptick", words), "AppTick");
  EXPECT_EQ(NearestWord("color", words), "");
  EXPECT_EQ(NearestWord("", words), "");
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_THAT(Split("a,,b,", ','), ElementsAre("a", "", "b", ""));
  EXPECT_THAT(Split("", ','), ElementsAre(""));
}

TEST(NumberText, ReadsBackEveryDouble) {
  for (const double value : {0.0, -0.0, 1.0 / 3.0, 1e-308, 1.7e308, -123456.789}) {
    EXPECT_EQ(ParseNumber(TextOf(value)), value);
  }
}

TEST(NumberText, WantsTheWholeTextAndAFiniteNumber) {
  EXPECT_EQ(ParseNumber(" +2.5\t"), 2.5);
  for (const char* text : {"", "1x", "1 2", "nan", "inf", "--1", "1,5", "0x10"}) {
    EXPECT_FALSE(ParseNumber(text).has_value()) << text;
  }
  EXPECT_FALSE(ParseInteger("1.0").has_value());
}

TEST(NumberText, ReadsMoosFlags) {
  EXPECT_EQ(ParseFlag("TRUE"), true);
  EXPECT_EQ(ParseFlag("0.5"), true);
  EXPECT_EQ(ParseFlag("off"), false);
  EXPECT_EQ(ParseFlag("-1"), false);
  EXPECT_FALSE(ParseFlag("maybe").has_value());
}

struct SampleParams {
  Meters altitude{4.0};
  Radians angle = Radians::FromTextUnit(30.0);
  int count = 3;
  bool is_on = false;
  std::string kind = "a";
  std::vector<std::string> lines{"default"};
  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("altitude_m", altitude, "Above the seabed", InRange(0.5_m, 100.0_m));
    visit("angle_deg", angle, "Half angle", InRange(0.0_deg, 90.0_deg));
    visit("count", count, "How many", AtLeast(1));
    visit("is_on", is_on, "Whether");
    visit.Choice("kind", kind, "Which", {"a", "b"});
    visit("line", lines, "One per line");
  }
};

SampleParams Read(std::vector<std::pair<std::string, std::string>> pairs) {
  ConfigBlock block{.name = "pSample", .where = {}, .entries = {}};
  for (auto& [key, value] : pairs) {
    block.entries.push_back({key, value, {"m.moos", static_cast<int>(block.entries.size()) + 1}});
  }
  return ReadParams<SampleParams>(block, {"AppTick"});
}
std::string ErrorsOf(std::vector<std::pair<std::string, std::string>> pairs) {
  try {
    Read(std::move(pairs));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Params, ConvertFromTheUnitOfTheText) {
  EXPECT_NEAR(Read({{"angle_deg", "45"}}).angle.value(), 0.785398163, 1e-9);
}

TEST(Params, AcceptTheirBoundsInDegrees) {
  EXPECT_EQ(ErrorsOf({{"angle_deg", "90"}, {"altitude_m", "0.5"}}), "");
}

TEST(Params, CompareKeysWithoutCase) { EXPECT_EQ(Read({{"COUNT", "7"}}).count, 7); }

TEST(Params, LetTheFirstLineReplaceADefaultListAndTheRestAdd) {
  EXPECT_THAT(Read({}).lines, ElementsAre("default"));
  EXPECT_THAT(Read({{"line", "x"}, {"line", "y"}}).lines, ElementsAre("x", "y"));
}

TEST(Params, PassKeysOfSomebodyElse) { EXPECT_EQ(ErrorsOf({{"apptick", "4"}}), ""); }

TEST(Params, ReportEveryProblemWithWhatIsAllowed) {
  const std::string errors = ErrorsOf({{"altitude_m", "0.1"},
                                       {"count", "1.5"},
                                       {"is_on", "maybe"},
                                       {"kind", "c"},
                                       {"altitud_m", "1"}});
  EXPECT_THAT(errors,
              HasSubstr("m.moos:1: altitude_m: `0.1` is not allowed; allowed: 0.5 to 100 m"));
  EXPECT_THAT(errors, HasSubstr("m.moos:2: count: `1.5`"));
  EXPECT_THAT(errors, HasSubstr("m.moos:3: is_on: `maybe`"));
  EXPECT_THAT(errors, HasSubstr("m.moos:4: kind: `c` is not allowed; allowed: a, b"));
  EXPECT_THAT(errors, HasSubstr("m.moos:5: altitud_m: unknown key in pSample; did you mean"));
}

TEST(Params, DescribeThemselves) {
  SampleParams params;
  const std::vector<ParamSpec> specs = DescribeParams(params);
  ASSERT_EQ(specs.size(), 6U);
  EXPECT_EQ(specs[1].unit, "deg");
  EXPECT_EQ(specs[1].default_text, "30");
  EXPECT_EQ(specs[0].allowed, "0.5 to 100 m");
  EXPECT_TRUE(specs[5].is_repeatable);
}

/// A mission's facts: only it can know them.
struct RequiringParams {
  Meters altitude{4.0};
  std::vector<std::string> files{"a.bhv", "b.bhv"};
  Meters margin{2.0};
  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit.Required("altitude_m", altitude, "Above the seabed", InRange(0.5_m, 100.0_m));
    visit.Required("file", files, "One per line");
    visit("margin_m", margin, "Around", AtLeast(0.0_m));
  }
};

std::string ComplaintsOf(const std::vector<ConfigEntry>& entries) {
  RequiringParams params;
  std::string text;
  const ConfigBlock block{.name = "pSample", .where = {"m.moos", 7}, .entries = entries};
  for (const ConfigProblem& problem : ApplyBlock(block, DescribeParams(params))) {
    text += problem.Format() + "\n";
  }
  return text;
}

TEST(RequiredParams, AreRefusedWithTheLineOfTheBlockThatLacksThem) {
  EXPECT_EQ(ComplaintsOf({{"margin_m", "1", {"m.moos", 9}}}),
            "m.moos:7: altitude_m: is missing in pSample and has no default; allowed: 0.5 to 100 "
            "m\nm.moos:7: file: is missing in pSample and has no default; allowed: text, one per "
            "line (may repeat)\n");
  EXPECT_EQ(ComplaintsOf({{"Altitude_M", "4", {}}, {"file", "c.bhv", {}}}), "");
}

TEST(RequiredParams, AMisspeltOneIsOneProblem) {
  EXPECT_EQ(ComplaintsOf({{"altitde_m", "4", {"m.moos", 8}}, {"file", "c.bhv", {}}}),
            "m.moos:8: altitde_m: unknown key in pSample; did you mean `altitude_m`?\n");
}

TEST(RequiredParams, HaveNoDefaultButAnExample) {
  RequiringParams params;
  const std::vector<ParamSpec> specs = DescribeParams(params);
  EXPECT_TRUE(specs[0].is_required);
  EXPECT_EQ(specs[0].default_text, "");
  EXPECT_THAT(specs[0].example, ElementsAre("4"));
  EXPECT_THAT(specs[1].example, ElementsAre("a.bhv", "b.bhv"));
  EXPECT_FALSE(specs[2].is_required);
  EXPECT_EQ(specs[2].default_text, "2");
}

}  // namespace
}  // namespace limpet
