// SPDX-License-Identifier: MIT
#include <chrono>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/logbook/alog_escape.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/alog_writer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr Seconds kStart{1767225600.0};

Message MessageOf(std::string name, Value value, double time = 0.0, std::string aux = "") {
  return {.name = std::move(name),
          .value = std::move(value),
          .time = kStart + Seconds(time),
          .source = "pNav",
          .source_aux = std::move(aux),
          .community = "alpha"};
}

class AlogTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "run.alog"; }
  void Write(const std::vector<Message>& messages, const AlogOptions& options = {}) const {
    Expected<AlogWriter> opened = AlogWriter::Open(file(), kStart, options);
    ASSERT_TRUE(opened.has_value());
    AlogWriter writer = *std::move(opened);
    for (const Message& message : messages) {
      writer.Write(message);
    }
    EXPECT_TRUE(writer.Flush());
  }
  [[nodiscard]] std::string Text() const {
    std::ifstream in(file());
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  [[nodiscard]] std::string LastLine() const {
    std::string text = Text();
    text.pop_back();
    return text.substr(text.rfind('\n') + 1);
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
};

TEST_F(AlogTest, BeginsWithTheBannerThatMoosToolsLookFor) {
  Write({});
  const std::string rule(59, '%');
  EXPECT_THAT(Text(), StartsWith(rule + "\n%% LOG FILE:       ./run.alog\n"
                                        "%% FILE OPENED ON  Thu Jan  1 00:00:00 2026\n"
                                        "%% LOGSTART                  1767225600 \n"));
  EXPECT_TRUE(Text().ends_with("\n" + rule + "\n"));
}

TEST_F(AlogTest, LaysOutDoublesInMoosColumns) {
  Write({MessageOf("NAV_X", 0.25, 0.4123)});
  EXPECT_EQ(LastLine(), "0.41230         NAV_X                pNav            0.25000      ");
}

TEST_F(AlogTest, PushesTheRestRightWhenAFieldIsWide) {
  Write({MessageOf("A_VARIABLE_OF_MORE_THAN_TWENTY", std::string("x y"), 12.5, "12:waypt_survey")},
        {.has_source_aux = true});
  EXPECT_EQ(LastLine(), "12.50000        A_VARIABLE_OF_MORE_THAN_TWENTY pNav:12:waypt_survey x y ");
}

TEST_F(AlogTest, WritesAsManyDecimalsAsAsked) {
  Write({MessageOf("A", 1.0 / 3.0)}, {.double_precision = 9});
  EXPECT_THAT(LastLine(), HasSubstr(" 0.333333333  "));
}

TEST_F(AlogTest, MarksTypesAndForeignCommunities) {
  Message foreign = MessageOf("A", 1.0);
  foreign.community = "bravo";
  Write({foreign},
        {.marks_data_type = true, .marks_other_communities = true, .community = "alpha"});
  EXPECT_THAT(LastLine(), HasSubstr("pNav@bravo      D:1.00000"));
  EXPECT_THAT(Text(), HasSubstr("%% DATATYPE MARKING ON\n"));
}

TEST_F(AlogTest, ReadsBackWhatItWrote) {
  Write({MessageOf("A", 2.5, -1.0), MessageOf("B", std::string("x=1, y=2"), 3.0, "aux")},
        {.has_source_aux = true});
  Expected<AlogReader> opened = AlogReader::Open(file());
  ASSERT_TRUE(opened.has_value());
  AlogReader reader = *std::move(opened);
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(reader.start(), kStart);
  EXPECT_DOUBLE_EQ(entry.time, -1.0);
  EXPECT_EQ(entry.name, "A");
  EXPECT_EQ(entry.number, 2.5);
  EXPECT_EQ(entry.value, "2.50000");
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.source, "pNav");
  EXPECT_EQ(entry.aux, "aux");
  EXPECT_EQ(entry.value, "x=1, y=2");
  EXPECT_EQ(entry.number, std::nullopt);
  EXPECT_FALSE(reader.Next(entry));
  EXPECT_EQ(reader.skipped_lines(), 0U);
}

TEST_F(AlogTest, KeepsAnyStringInOneLine) {
  const std::vector<std::string> texts{"a\nb",    "\n",   "\\n",     "tail\\", "",     " lead",
                                       "trail  ", "\r\n", "\t\ttab", "a\\ b",  "%% x", "\\ x"};
  std::vector<Message> messages;
  for (const std::string& text : texts) {
    messages.push_back(MessageOf("T", text));
  }
  Write(messages);
  AlogReader reader = *AlogReader::Open(file());
  AlogEntry entry;
  for (const std::string& text : texts) {
    ASSERT_TRUE(reader.Next(entry));
    EXPECT_EQ(entry.value, text);
  }
  EXPECT_FALSE(reader.Next(entry));
}

TEST_F(AlogTest, ReplacesBlanksInNamesAndSources) {
  Message odd = MessageOf("A B", 1.0);
  odd.source = "my\napp";
  Write({odd});
  AlogReader reader = *AlogReader::Open(file());
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.name, "A_B");
  EXPECT_EQ(entry.source, "my_app");
}

TEST_F(AlogTest, PutsBinariesInTheBlogAndReadsThemBack) {
  const Binary bytes{std::byte{1}, std::byte{0}, std::byte{255}};
  Write({MessageOf("F", Binary{std::byte{7}}), MessageOf("G", bytes)});
  AlogReader reader = *AlogReader::Open(file());
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry) && reader.Next(entry));
  const auto span = ParseBlogMarker(entry.value);
  ASSERT_TRUE(span.has_value());
  EXPECT_EQ(*ReadBlog(folder_, *span), bytes);
}

TEST_F(AlogTest, SaysWhenItCannotBeCreated) {
  EXPECT_FALSE(AlogWriter::Open(folder_ / "no/such/run.alog", kStart, {}).has_value());
  EXPECT_FALSE(AlogReader::Open(folder_ / "none.alog").has_value());
}

TEST(AlogReader, SkipsWhatMoosToolsSkip) {
  AlogReader reader = AlogReader::OfText(
      "%% LOGSTART  100.5\nbroken line\n1.0 A\n2.0 A pNav\n3.0 A pNav 5.00000      \n"
      "1:02 A pNav 1\n\n4.0 B pNav:x:y  a \\n b \n");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.number, 5.0);
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.aux, "x:y");
  EXPECT_EQ(entry.value, "a \\n b") << "escapes are ours; a MOOS log has none";
  EXPECT_FALSE(reader.Next(entry));
  EXPECT_EQ(reader.start(), Seconds(100.5));
  EXPECT_EQ(reader.skipped_lines(), 4U);
}

TEST(AlogReader, DropsATornLastLine) {
  AlogReader reader = AlogReader::OfText("1.0 A pNav 1.0 \n2.0 A pNav 2.");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_FALSE(reader.Next(entry));
  EXPECT_TRUE(reader.has_torn_end());
}

TEST(AlogReader, ReadsStringsMarkedAsSuch) {
  AlogReader reader = AlogReader::OfText("%% DATATYPE MARKING ON\n1.0 A p S:5 \n1.0 A p D:5 \n");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.value, "5");
  EXPECT_FALSE(entry.number.has_value());
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.number, 5.0);
}

TEST(AlogReader, ReadsWindowsLineEnds) {
  AlogReader reader = AlogReader::OfText("1.0 A p x \r\n");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.value, "x");
}

TEST(AlogReader, TakesTheIverLogsAsTheyAre) {
  const std::filesystem::path folder =
      std::filesystem::path(LIMPET_SOURCE_DIR) /
      "../shared/data/iver_umassd/simulation/iver__18_12_2016_____17_26_26";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "no shared data";
  }
  // Column extracts without names: not one line is an entry, and none may be mistaken for one.
  AlogReader extract = *AlogReader::Open(folder / "nav_xy.alog");
  AlogEntry entry;
  EXPECT_FALSE(extract.Next(entry));
  EXPECT_GT(extract.skipped_lines(), 1000U);
  AlogReader system = *AlogReader::Open(folder / "iver__18_12_2016_____17_26_26.ylog");
  while (system.Next(entry)) {
    EXPECT_FALSE(entry.name.empty());
  }
  ASSERT_TRUE(system.start().has_value());
  EXPECT_DOUBLE_EQ(system.start()->value(), 14820999866.9);
}

TEST(BlogMarker, RefusesWhatIsNone) {
  for (const char* text :
       {"", "x", "<MOOS_BINARY></MOOS_BINARY>", "<MOOS_BINARY>File=,Offset=1,Bytes=2</MOOS_BINARY>",
        "<MOOS_BINARY>File=a,Offset=-1,Bytes=2</MOOS_BINARY>", "<MOOS_BINARY>"}) {
    EXPECT_FALSE(ParseBlogMarker(text).has_value()) << text;
  }
}

TEST(BlogMarker, LeadsNowhereElse) {
  EXPECT_FALSE(ReadBlog("/nonexistent", {.file = "/etc/passwd", .offset = 0, .bytes = 1}));
}

TEST(CalendarText, NamesDaysAsCtimeDoes) {
  EXPECT_EQ(CalendarText(Seconds(1795245600.0)), "Sat Nov 21 07:20:00 2026");
  EXPECT_EQ(CalendarText(Seconds(951782400.0)), "Tue Feb 29 00:00:00 2000");
}

}  // namespace
}  // namespace limpet
