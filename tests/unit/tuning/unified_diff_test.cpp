// SPDX-License-Identifier: MIT
#include "limpet/tuning/unified_diff.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "tests/support/limpet_command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

std::string Lines(int count, const std::string& end = "\n") {
  std::string text;
  for (int i = 1; i <= count; ++i)
    text += "line " + std::to_string(i) + end;
  return text;
}

/// What `patch` makes of it.
std::string Patched(const std::string& text, const std::vector<LineEdit>& edits) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "f.bhv") << text;
  std::ofstream(folder.path() / "d") << UnifiedDiff("f.bhv", text, edits);
  const std::string command = "cd " + folder.path().string() +
                              " && patch -p1 --no-backup-if-mismatch"
                              " --fuzz=0 -s <d >log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << TextOfFile(folder.path() / "log");
  return TextOfFile(folder.path() / "f.bhv");
}

bool HasPatch() { return std::system("patch --version >/dev/null 2>&1") == 0; }

TEST(UnifiedDiff, IsWhatDiffWrites) {
  EXPECT_EQ(UnifiedDiff("a/f.bhv", Lines(9), {{.line = 5, .text = "new"}}),
            "--- a/a/f.bhv\n+++ b/a/f.bhv\n@@ -2,7 +2,7 @@\n line 2\n line 3\n line 4\n-line 5\n"
            "+new\n line 6\n line 7\n line 8\n");
  EXPECT_EQ(UnifiedDiff("f", "a\n", {}), "");
}

TEST(UnifiedDiff, AppliesWhereverTheEditsAre) {
  if (!HasPatch()) GTEST_SKIP() << "no patch on this machine";
  for (int first = 1; first <= 20; ++first) {
    for (int second = first + 1; second <= 20; second += 3) {
      const std::string patched =
          Patched(Lines(20), {{.line = second, .text = "after", .is_inserted = true},
                              {.line = first, .text = "instead"}});
      std::string expected;
      for (int i = 1; i <= 20; ++i) {
        expected += i == first ? "instead\n" : "line " + std::to_string(i) + "\n";
        if (i == second) expected += "after\n";
      }
      ASSERT_EQ(patched, expected) << first << " " << second;
    }
  }
}

TEST(UnifiedDiff, KeepsLineEndsAsTheyAre) {
  if (!HasPatch()) GTEST_SKIP() << "no patch on this machine";
  EXPECT_EQ(Patched("a\r\nb\r\n", {{.line = 2, .text = "B"}}), "a\r\nB\r\n");
  EXPECT_EQ(Patched("a\nb", {{.line = 2, .text = "B"}}), "a\nB");
  EXPECT_EQ(Patched("a\nb", {{.line = 2, .text = "c", .is_inserted = true}}), "a\nb\nc\n");
  EXPECT_EQ(Patched("a\nb", {{.line = 1, .text = "A"}}), "A\nb");
}

}  // namespace
}  // namespace limpet
