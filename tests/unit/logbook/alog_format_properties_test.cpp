// SPDX-License-Identifier: MIT
// What is written into a log is read from it: any text, any name, in one piece or in any pieces.
#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/durable/append_file.hpp"
#include "limpet/logbook/alog_escape.hpp"
#include "limpet/logbook/alog_format.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/blog.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

constexpr Seconds kPropertyStart{1767225600.0};

/// Bytes that logs stumble over, among others.
std::string DrawText(Random& random, std::size_t longest) {
  constexpr std::string_view kOdd{"\n\r\\ \t%,=n0r\0", 12};
  std::string text;
  for (std::size_t i = random.Index(longest + 1); i > 0; --i) {
    text +=
        random.Chance(0.5) ? kOdd[random.Index(kOdd.size())] : static_cast<char>(random.Index(256));
  }
  return text;
}

class AlogProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "alog"};
};

TEST_P(AlogProperties, EscapedTextIsOneLineAndComesBack) {
  for (int i = 0; i < 500; ++i) {
    const std::string text = DrawText(random_, 40);
    std::string escaped, back;
    AppendEscaped(escaped, text);
    EXPECT_EQ(escaped.find_first_of(std::string_view("\n\r\0", 3)), std::string::npos);
    EXPECT_FALSE(escaped.starts_with(' ') || escaped.starts_with('\t'));
    AppendUnescaped(back, escaped);
    EXPECT_EQ(back, text);
  }
}

TEST_P(AlogProperties, TextThatWasNeverEscapedIsReadWithoutHarm) {
  for (int i = 0; i < 500; ++i) {
    const std::string text = DrawText(random_, 40);
    std::string read;
    AppendUnescaped(read, text);
    EXPECT_LE(read.size(), text.size());
    std::string twice;
    AppendEscaped(twice, text);
    EXPECT_LE(twice.size(), 2 * text.size() + 1);
  }
}

TEST_P(AlogProperties, EveryEntryComesBackWithItsValue) {
  const AlogFormat format(kPropertyStart, {.double_precision = 9});
  std::string text;
  format.AppendBanner(text, "drawn.alog");
  std::vector<Message> written;
  for (int i = 0; i < 100; ++i) {
    Message message{.name = "VAR_" + std::to_string(random_.Index(9)),
                    .value = random_.Normal(1e3),
                    .time = kPropertyStart + Seconds(random_.Uniform(0.0, 1e5)),
                    .source = "pApp" + std::to_string(random_.Index(5)),
                    .source_aux = "",
                    .community = ""};
    // A text that looks like a number or begins with a blank is MOOS's to read otherwise.
    if (random_.Chance(0.5)) message.value = "x" + DrawText(random_, 30) + "x";
    format.AppendLine(text, message);
    written.push_back(message);
  }
  AlogReader reader = AlogReader::OfText(text);
  AlogEntry entry;
  for (const Message& message : written) {
    ASSERT_TRUE(reader.Next(entry));
    EXPECT_EQ(entry.name, message.name);
    EXPECT_EQ(entry.source, message.source);
    EXPECT_NEAR(entry.time, (message.time - kPropertyStart).value(), 1e-4);
    if (const auto* number = std::get_if<double>(&message.value)) {
      ASSERT_TRUE(entry.number);
      EXPECT_NEAR(*entry.number, *number, 1e-8);
    } else {
      EXPECT_EQ(entry.value, std::get<std::string>(message.value));
    }
  }
  EXPECT_FALSE(reader.Next(entry));
  EXPECT_EQ(reader.skipped_lines(), 0U);
}

TEST_P(AlogProperties, NamesOfAnyBytesStayOneWord) {
  const AlogFormat format(kPropertyStart, {});
  for (int i = 0; i < 200; ++i) {
    std::string line;
    const Message message{.name = DrawText(random_, 12),
                          .value = 1.0,
                          .time = kPropertyStart,
                          .source = DrawText(random_, 12),
                          .source_aux = "",
                          .community = ""};
    format.AppendLine(line, message);
    if (line.find('%') != std::string::npos) continue;  // may look like a comment
    AlogReader reader = AlogReader::OfText(line);
    AlogEntry entry;
    ASSERT_TRUE(reader.Next(entry)) << line;
    EXPECT_EQ(entry.name.size(), message.name.empty() ? 1U : message.name.size());
    EXPECT_FALSE(reader.Next(entry));
  }
}

TEST_P(AlogProperties, BinariesLieWhereTheirMarkersSay) {
  const TemporaryFolder folder;
  BlogWriter writer(folder.path() / "drawn.blog");
  std::vector<std::pair<std::string, Binary>> written;
  for (int i = 0; i < 20; ++i) {
    Binary bytes(random_.Index(200));
    for (std::byte& byte : bytes)
      byte = static_cast<std::byte>(random_.Index(256));
    const auto marker = writer.Write(bytes);
    ASSERT_TRUE(marker);
    written.emplace_back(*marker, bytes);
  }
  ASSERT_TRUE(writer.Sync());
  for (const auto& [marker, bytes] : written) {
    const auto span = ParseBlogMarker(marker);
    ASSERT_TRUE(span);
    EXPECT_EQ(span->bytes, bytes.size());
    const auto read = ReadBlog(folder.path(), *span);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, bytes);
    BlogSpan beyond = *span;
    beyond.bytes += 1000000;
    EXPECT_FALSE(ReadBlog(folder.path(), beyond));
  }
}

TEST_P(AlogProperties, AMarkerWithALostCharacterNeverLeadsElsewhere) {
  const std::string good = "<MOOS_BINARY>File=a.blog,Offset=12,Bytes=34</MOOS_BINARY>";
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad.erase(at, 1);
    const auto span = ParseBlogMarker(bad);
    if (!span) continue;
    EXPECT_EQ(BlogPath("/logs", *span).parent_path(), "/logs");
  }
}

TEST_P(AlogProperties, AFileIsWhatWasAppendedToIt) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "grown.txt";
  std::string expected;
  for (int session = 0; session < 3; ++session) {
    Expected<AppendFile> opened =
        session == 0 ? AppendFile::Create(path) : AppendFile::Continue(path);
    ASSERT_TRUE(opened);
    AppendFile file = *std::move(opened);
    EXPECT_EQ(file.size(), expected.size());
    for (int i = 0; i < 10; ++i) {
      const std::string piece = DrawText(random_, 60);
      ASSERT_TRUE(file.Append(piece));
      expected += piece;
    }
    if (expected.size() > 8) {
      const std::size_t at = random_.Index(expected.size() - 4);
      ASSERT_TRUE(file.Overwrite(at, "over"));
      expected.replace(at, 4, "over");
    }
    ASSERT_TRUE(file.Sync());
  }
  std::ifstream in(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), expected);
}

TEST_P(AlogProperties, LinesGoOnBehindTheLastWholeOne) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "torn.txt";
  std::string whole;
  for (std::size_t i = random_.Index(5); i > 0; --i)
    whole += std::to_string(random_.Bits()) + "\n";
  std::ofstream(path, std::ios::binary) << whole << std::string(random_.Index(30), 'x');
  Expected<AppendFile> file = AppendFile::ContinueLines(path);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->size(), whole.size());
  ASSERT_TRUE(file->Append("next\n"));
  std::ifstream in(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), whole + "next\n");
}

INSTANTIATE_TEST_SUITE_P(Drawn, AlogProperties, ::testing::Range(1, 7));

TEST(CalendarText, AgreesWithTheSystemsCalendarOnAnyDay) {
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const auto at = static_cast<std::time_t>(random.Index(4'000'000'000U));
    std::tm calendar{};
    gmtime_r(&at, &calendar);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%a %b %e %H:%M:%S %Y", &calendar);
    EXPECT_EQ(CalendarText(Seconds(static_cast<double>(at))), text.data());
  }
}

}  // namespace
}  // namespace limpet
