// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_writer.hpp"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/blog.hpp"
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

class AlogWriterTest : public ::testing::Test {
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

TEST_F(AlogWriterTest, BeginsWithTheBannerThatMoosToolsLookFor) {
  Write({});
  const std::string rule(59, '%');
  EXPECT_THAT(Text(), StartsWith(rule + "\n%% LOG FILE:       ./run.alog\n"
                                        "%% FILE OPENED ON  Thu Jan  1 00:00:00 2026\n"
                                        "%% LOGSTART                  1767225600 \n"));
  EXPECT_TRUE(Text().ends_with("\n" + rule + "\n"));
}

TEST_F(AlogWriterTest, LaysOutDoublesInMoosColumns) {
  Write({MessageOf("NAV_X", 0.25, 0.4123)});
  EXPECT_EQ(LastLine(), "0.41230         NAV_X                pNav            0.25000      ");
}

TEST_F(AlogWriterTest, PushesTheRestRightWhenAFieldIsWide) {
  Write({MessageOf("A_VARIABLE_OF_MORE_THAN_TWENTY", std::string("x y"), 12.5, "12:waypt_survey")},
        {.has_source_aux = true});
  EXPECT_EQ(LastLine(), "12.50000        A_VARIABLE_OF_MORE_THAN_TWENTY pNav:12:waypt_survey x y ");
}

TEST_F(AlogWriterTest, WritesAsManyDecimalsAsAsked) {
  Write({MessageOf("A", 1.0 / 3.0)}, {.double_precision = 9});
  EXPECT_THAT(LastLine(), HasSubstr(" 0.333333333  "));
}

TEST_F(AlogWriterTest, MarksTypesAndForeignCommunities) {
  Message foreign = MessageOf("A", 1.0);
  foreign.community = "bravo";
  Write({foreign},
        {.marks_data_type = true, .marks_other_communities = true, .community = "alpha"});
  EXPECT_THAT(LastLine(), HasSubstr("pNav@bravo      D:1.00000"));
  EXPECT_THAT(Text(), HasSubstr("%% DATATYPE MARKING ON\n"));
}

TEST_F(AlogWriterTest, ReadsBackWhatItWrote) {
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

TEST_F(AlogWriterTest, KeepsAnyStringInOneLine) {
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

TEST_F(AlogWriterTest, ReplacesBlanksInNamesAndSources) {
  Message odd = MessageOf("A B", 1.0);
  odd.source = "my\napp";
  Write({odd});
  AlogReader reader = *AlogReader::Open(file());
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.name, "A_B");
  EXPECT_EQ(entry.source, "my_app");
}

TEST_F(AlogWriterTest, PutsBinariesInTheBlogAndReadsThemBack) {
  const Binary bytes{std::byte{1}, std::byte{0}, std::byte{255}};
  Write({MessageOf("F", Binary{std::byte{7}}), MessageOf("G", bytes)});
  AlogReader reader = *AlogReader::Open(file());
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry) && reader.Next(entry));
  const auto span = ParseBlogMarker(entry.value);
  ASSERT_TRUE(span.has_value());
  EXPECT_EQ(*ReadBlog(folder_, *span), bytes);
}

TEST_F(AlogWriterTest, SaysWhenItCannotBeCreated) {
  EXPECT_FALSE(AlogWriter::Open(folder_ / "no/such/run.alog", kStart, {}).has_value());
  EXPECT_FALSE(AlogReader::Open(folder_ / "none.alog").has_value());
}

}  // namespace
}  // namespace limpet
