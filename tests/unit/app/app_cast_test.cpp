// SPDX-License-Identifier: MIT
#include "limpet/app/app_cast.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/report_lines.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

AppCast FullCast() {
  return {.process = "pHelmIvP",
          .node = "alpha",
          .iteration = 120,
          .messages = {"line1", "line2"},
          .config_warnings = {"w1", "w2"},
          .events = {"[3.12]: text", "[9.50]: text"},
          .run_warning_total = 3,
          .run_warnings = {{"text", 2}, {"text", 1}}};
}

TEST(AppCast, IsWrittenAsViewersReadIt) {
  EXPECT_EQ(EncodeAppCast(FullCast()),
            "proc=pHelmIvP!@#iter=120!@#node=alpha!@#iter=120!@#messages=line1!@line2!@!@#"
            "config_warnings=w1!@w2!@#events_total=2!@#events=[3.12]: text!@[9.50]: text!@#"
            "run_warning_total=3!@#run_warnings=2:text!@1:text");
}

TEST(AppCast, EmptyFieldsKeepTheirSeparators) {
  EXPECT_EQ(EncodeAppCast({.process = "pNav", .iteration = 1}),
            "proc=pNav!@#iter=1!@#iter=1!@#messages=!@#!@#events_total=0!@#!@#run_warning_total=0"
            "!@#");
}

TEST(AppCast, ALineCannotBreakTheFields) {
  AppCast cast{.process = "pNav", .iteration = 1, .messages = {"a!@#b", "# c", "d!", "e\nf"}};
  const auto back = DecodeAppCast(EncodeAppCast(cast));
  ASSERT_TRUE(back);
  EXPECT_THAT(back->messages, ElementsAre("a! @#b", " # c", "d! ", "e f"));
}

std::string RandomLine(Random& random) {
  static constexpr std::string_view kLetters = "ab =:,.#@![]{}(1)";
  std::string line = "x";
  for (auto i = random.Index(12); i > 0; --i) {
    line += kLetters[random.Index(kLetters.size())];
  }
  return line;
}

std::vector<std::string> RandomLines(Random& random, std::uint64_t least) {
  std::vector<std::string> lines;
  for (auto i = least + random.Index(6); i > 0; --i) {
    lines.push_back(RandomLine(random));
  }
  return lines;
}

TEST(AppCast, ComesBackFromItsTextWhateverItsLinesHold) {
  Random random(1, "appcasts");
  for (int i = 0; i < 500; ++i) {
    const AppCast cast{.process = "pNav",
                       .node = i % 2 == 0 ? "alpha" : "",
                       .iteration = static_cast<std::int64_t>(random.Index(1'000'000)),
                       .messages = RandomLines(random, 0),
                       .config_warnings = RandomLines(random, 1),
                       .events = RandomLines(random, 0),
                       .run_warning_total = i,
                       .run_warnings = {{RandomLine(random), i}}};
    const std::string text = EncodeAppCast(cast);
    const auto back = DecodeAppCast(text);
    ASSERT_TRUE(back) << text;
    EXPECT_EQ(back->messages.size(), cast.messages.size()) << text;
    EXPECT_EQ(back->events.size(), cast.events.size()) << text;
    EXPECT_EQ(back->run_warnings.size(), 1U) << text;
    EXPECT_EQ(EncodeAppCast(*back), text);
  }
}

TEST(AppCastRequest, IsReadAsViewersWriteIt) {
  const auto request = ParseAppCastRequest(
      "node=alpha,app=pHelm,duration=3.0,key=pMarineViewer:alpha:pHelm:app,thresh=run_warning");
  ASSERT_TRUE(request);
  EXPECT_TRUE(request->IsFor("pHelm", "alpha"));
  EXPECT_FALSE(request->IsFor("pNav", "alpha"));
  EXPECT_FALSE(request->IsFor("pHelm", "bravo"));
  EXPECT_EQ(request->duration, Seconds(3.0));
  EXPECT_TRUE(request->wants_warnings_only);
}

TEST(AppCastRequest, LastsAtMostHalfAMinute) {
  EXPECT_EQ(ParseAppCastRequest("key=a,duration=1e9")->duration, Seconds(30.0));
  EXPECT_EQ(ParseAppCastRequest("key=a,duration=-1")->duration, Seconds(0.0));
  EXPECT_EQ(ParseAppCastRequest("key=a,duration=nan")->duration, Seconds(0.0));
}

TEST(AppCastRequest, WithoutAKeyIsNone) {
  EXPECT_FALSE(ParseAppCastRequest("node=all,app=all,duration=3"));
  EXPECT_FALSE(ParseAppCastRequest("key=" + std::string(201, 'k')));
  EXPECT_FALSE(ParseAppCastRequest(""));
}

TEST(ReportTable, AlignsWordsLeftAndNumbersRight) {
  ReportTable table({"object", ">sure"});
  table.AddRow({"buoy", "0.9"});
  table.AddRow({"a"});
  EXPECT_THAT(table.Lines(),
              ElementsAre("  object  sure", "  ------  ----", "  buoy     0.9", "  a"));
}

TEST(ReportLines, CutsWhatATerminalCannotShow) {
  ReportLines report;
  report.Add(std::string(100, 'x'));
  EXPECT_EQ(report.lines()[0], std::string(76, 'x') + "..");
}

}  // namespace
}  // namespace limpet
