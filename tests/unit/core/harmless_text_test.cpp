// SPDX-License-Identifier: MIT
#include "limpet/core/harmless_text.hpp"

#include <gtest/gtest.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

TEST(HarmlessText, LeavesWordsOfAnyLanguageAlone) {
  EXPECT_EQ(HarmlessText("bouée 1, μ = 2, 海底"), "bouée 1, μ = 2, 海底");
}

TEST(HarmlessText, WritesOutWhatATerminalObeys) {
  EXPECT_EQ(HarmlessText("a\033[2Jb\r\n\x7f"), "a\\x1b[2Jb\\r\\n\\x7f");
  EXPECT_EQ(HarmlessText("\xC2\x9B"
                         "31m"),
            "\\u009b31m")
      << "the one-character escape";
  EXPECT_EQ(HarmlessText("\xE2\x80\xAE"
                         "gpj"),
            "\\u202egpj")
      << "right to left";
}

TEST(HarmlessText, WritesOutBytesThatAreNoCharacters) {
  EXPECT_EQ(HarmlessText("a\x9b"
                         "b\xC3"),
            "a\\x9bb\\xc3");
  EXPECT_EQ(HarmlessText("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
}

TEST(ConfigProblem, IsOneLineThatNoTerminalObeys) {
  const ConfigProblem problem{{"a\033]0;x\007.moos", 3}, "key\033[31m", "`\033[2J`\nis no number"};
  EXPECT_EQ(problem.Format(), "a\\x1b]0;x\\x07.moos:3: key\\x1b[31m: `\\x1b[2J`\\nis no number");
}

}  // namespace
}  // namespace limpet
