// SPDX-License-Identifier: MIT
#include "tests/layers/citations.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/tree_files.hpp"

namespace limpet::layers {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::set<std::string> ReferencesOfThePage() {
  return ReadReferences(
      ReadAll(std::filesystem::path(LIMPET_SOURCE_DIR) / "docs" / "references.md"));
}

TEST(Citations, OfEveryCommentAreEntriesOfTheReferences) {
  const std::vector<SourceFile> files = TreeFiles();
  std::size_t cited = 0;
  for (const SourceFile& file : files)
    cited += CitationsIn(file).size();
  EXPECT_GT(cited, 20U) << "no citations were found";
  EXPECT_THAT(CitationsWithoutEntry(files, ReferencesOfThePage()), IsEmpty());
}

TEST(Citations, AreReadFromTheEntriesOfThePage) {
  EXPECT_THAT(ReadReferences("# References\n- **[Kuhn 1955]** H. W. Kuhn, 1955.\n"
                             "- **[Bar-Shalom 2001]** Y. Bar-Shalom, 2001. As [Reid 1979] says.\n"
                             "## Unlike [Neira 2001]\n"),
              ElementsAre("Bar-Shalom 2001", "Kuhn 1955"));
  EXPECT_THAT(ReferencesOfThePage(), Contains("Kuhn 1955"));
}

TEST(Citations, AreFoundInCommentsAlone) {
  EXPECT_THAT(CitationsIn({"a.cpp",
                           "/// Least cost [Kuhn 1955]; [m], [Hz 1], [0, 1999], [s since 1970] are "
                           "none.\n"
                           "// Differences [von Neumann 1941].\n"
                           "int a = b[K 1955];  ///< [Jaffe 1990, the scattered component]\n"
                           "const char* c = \"[Brier 1950]\";\n"
                           "// A line may end within [Bar-Shalom\n// 2001].\n"
                           "// But no code lies [Reid\nint d;\n// 1979] within.\n"}),
              ElementsAre("Kuhn 1955", "von Neumann 1941", "Jaffe 1990", "Bar-Shalom 2001"));
}

TEST(Citations, WithoutAnEntryAreComplainedAbout) {
  const SourceFile file{"a.hpp",
                        "// Both [Kuhn 1955] and [Nobody "
                        "1901] say so.\n"};
  EXPECT_THAT(CitationsWithoutEntry({file}, {"Kuhn 1955"}),
              ElementsAre("a.hpp: [Nobody 1901] is not in docs/references.md"));
  EXPECT_THAT(CitationsWithoutEntry({file}, {"Kuhn 1955", "Nobody 1901"}), IsEmpty());
}

}  // namespace
}  // namespace limpet::layers
