// SPDX-License-Identifier: MIT
#include "apps/limpet/command_line.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/verbs.hpp"
#include "limpet/core/config.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Answer {
  int code = 0;
  std::string out, err;
};

Answer Limpet(const std::vector<std::string>& words) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  Answer answer;
  answer.code = RunCommandLine(words);
  answer.out = ::testing::internal::GetCapturedStdout();
  answer.err = ::testing::internal::GetCapturedStderr();
  return answer;
}

/// Every command that has a help of its own.
std::vector<std::vector<std::string>> Commands() {
  std::vector<std::vector<std::string>> commands;
  for (const Verb& verb : Verbs())
    commands.push_back({verb.name});
  for (const char* command : {"scan", "stat", "grep", "clip", "csv", "recover"})
    commands.push_back({"log", command});
  return commands;
}

/// Columns, a letter of several bytes being one of them.
std::size_t WidthOf(const std::string& line) {
  return static_cast<std::size_t>(
      std::ranges::count_if(line, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

TEST(CommandLine, HelpsWithEveryVerbInTheWidthOfATerminal) {
  for (std::vector<std::string> words : Commands()) {
    words.emplace_back("--help");
    const Answer answer = Limpet(words);
    EXPECT_EQ(answer.code, kOk) << words[0];
    EXPECT_THAT(answer.out, StartsWith("usage: limpet " + words[0]));
    EXPECT_EQ(answer.err, "");
    for (const std::string& line : Split(answer.out, '\n')) {
      EXPECT_LE(WidthOf(line), 80U) << words[0] << ": " << line;
    }
  }
}

TEST(CommandLine, HelpOfAVerbMayBeAskedForInFront) {
  EXPECT_EQ(Limpet({"help", "survey"}).out, Limpet({"survey", "--help"}).out);
  EXPECT_EQ(Limpet({"help", "log", "grep"}).out, Limpet({"log", "grep", "-h"}).out);
  EXPECT_EQ(Limpet({"--help", "nav"}).out, Limpet({"nav", "--help"}).out);
}

TEST(CommandLine, HelpIsGivenWhateverElseIsWrong) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"survey", "--seed", "many", "--help"},
        {"nav", "--help", "--outt"},
        {"tables", "a", "b", "-h"}}) {
    const Answer answer = Limpet(words);
    EXPECT_EQ(answer.code, kOk) << words[0];
    EXPECT_THAT(answer.out, StartsWith("usage: limpet " + words[0]));
  }
}

TEST(CommandLine, ListsEveryVerbInTheWidthOfATerminal) {
  const Answer answer = Limpet({"help"});
  EXPECT_EQ(answer.code, kOk);
  for (const Verb& verb : Verbs()) {
    EXPECT_THAT(answer.out, HasSubstr(std::string("\n  ") + verb.name + ' '));
  }
  for (const std::string& line : Split(answer.out, '\n')) {
    EXPECT_LE(line.size(), 80U) << line;
  }
  EXPECT_EQ(Limpet({}).code, kUsage) << "nothing is no command";
}

TEST(CommandLine, NamesTheNearestVerb) {
  const Answer answer = Limpet({"survye", "missions/table1"});
  EXPECT_EQ(answer.code, kUsage);
  EXPECT_EQ(answer.err,
            "limpet: no verb `survye`; did you mean `survey`?; `limpet --help` lists them\n");
}

struct WrongLine {
  std::vector<std::string> words;
  std::string complaint;
};

TEST(CommandLine, SaysWhatIsWrongAndWhatWouldBeRight) {
  for (const WrongLine& wrong : std::vector<WrongLine>{
           {{"survey"}, "survey takes one mission folder, e.g. missions/table1"},
           {{"survey", "a", "b"}, "survey takes one mission folder, e.g. missions/table1"},
           {{"survey", "a", "--sede", "3"}, "unknown option --sede; did you mean --seed?"},
           {{"survey", "--sede=3"}, "unknown option --sede; did you mean --seed?"},
           {{"survey", "a", "-v"}, "unknown option -v"},
           {{"survey", "a", "--seed"}, "--seed needs a value"},
           {{"survey", "a", "--seed", "x1"}, "--seed takes a whole number of at least 0, not `x1`"},
           {{"survey", "a", "--seed=-1"}, "--seed takes a whole number of at least 0, not `-1`"},
           {{"survey", "a", "--out="}, "--out takes a folder, not an empty word"},
           {{"survey", "a", "--out", ""}, "--out takes a folder, not an empty word"},
           {{"survey", "a", "--without-truth=no"}, "--without-truth takes no value"},
           {{"tables", "a", "--runs", "0"}, "--runs takes a whole number of at least 1, not `0`"},
           {{"tables", "a", "--jobs=1.5"}, "--jobs takes a whole number of at least 1, not `1.5`"},
           {{"nav", "stream"},
            "nav takes one recording (a folder or a file), and --out DIR or --check"},
           {{"change", "--session-a", "a"}, "change takes --session-a DIR and --session-b DIR"},
           {{"detect", "a.png"}, "detect takes images and --out FILE"},
           {{"detect", "a", "--out", "b", "--min-confidence", "7"},
            "--min-confidence takes 0 to 1, not `7`"},
           {{"report", ""}, "report takes one run folder, e.g. runs/table1-1"},
           {{"key", "make", "k"},
            "key takes `new` or `show`, and a file; `limpet key --help` says more"}}) {
    const Answer answer = Limpet(wrong.words);
    EXPECT_EQ(answer.code, kUsage) << wrong.complaint;
    EXPECT_EQ(answer.err, "limpet: " + wrong.complaint + "\n");
    EXPECT_EQ(answer.out, "");
  }
}

}  // namespace
}  // namespace limpet
