// SPDX-License-Identifier: MIT
#include "tests/layers/layers.hpp"

#include <filesystem>
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/cited_code.hpp"
#include "tests/layers/test_subjects.hpp"
#include "tests/layers/tree_files.hpp"
#include "tests/layers/type_names.hpp"

namespace limpet::layers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const LayerTable& SmallTable() {
  static const LayerTable table = ReadLayerTable(
      "text\n| library | what | may use | kept out |\n| --- | --- | --- | --- |\n"
      "| core | units | - | fmt |\n| vision | eyes | core | OpenCV |\n"
      "| estimation/* | beliefs | core, each other | |\n\n| app | later table | core | |\n");
  return table;
}

std::vector<std::string> Check(const std::vector<SourceFile>& files) {
  return Violations(files, SmallTable());
}

TEST(Layers, EveryIncludeOfTheTreeIsInTheTableOfTheArchitecture) {
  const std::vector<SourceFile> files = TreeFiles();
  EXPECT_GT(files.size(), 100U) << "the tree was not found";
  const LayerTable table =
      ReadLayerTable(ReadAll(std::filesystem::path(LIMPET_SOURCE_DIR) / "docs/architecture.md"));
  EXPECT_GT(table.size(), 10U) << "the table was not found";
  EXPECT_THAT(Violations(files, table), IsEmpty());
}

TEST(Layers, OneFileAloneReadsTheHeavyHeadersOfTheCommandLine) {
  std::vector<std::string> readers;
  for (const SourceFile& file : TreeFiles()) {
    if (file.text.find("#include <"
                       "CLI/") != std::string::npos)
      readers.push_back(file.path);
  }
  EXPECT_THAT(readers, ElementsAre("share/limpet/console/command_reader.cpp"));
}

TEST(Presets, NameTestsThatThereAre) {
  const std::filesystem::path root(LIMPET_SOURCE_DIR);
  const std::string presets = ReadAll(root / "CMakePresets.json");
  static const std::regex kTest("\"unit_(\\w+)\"");
  int named = 0;
  for (std::sregex_iterator test(presets.begin(), presets.end(), kTest), end; test != end; ++test) {
    const std::string folder = (*test)[1];
    EXPECT_TRUE(std::filesystem::is_directory(root / "tests/unit" / folder)) << folder;
    const std::regex filter("[(|]" + folder + "[|)]");
    EXPECT_TRUE(std::regex_search(presets, filter)) << folder << " is built and not run";
    ++named;
  }
  EXPECT_GT(named, 5);
}

TEST(TypeNames, AreEachOfOneType) { EXPECT_THAT(TypesDefinedTwice(TreeFiles()), IsEmpty()); }

TEST(TypeNames, OfTwoFilesThatDefineTheSameAreComplainedAbout) {
  const SourceFile a{"a.hpp", "namespace limpet {\nstruct Frame {\n};\n}  // namespace limpet\n"};
  const SourceFile b{
      "b.hpp", "namespace limpet {\nclass Frame final : public X {\n}  // namespace limpet\n"};
  const SourceFile hidden{"c.cpp",
                          "namespace limpet {\nnamespace {\nstruct Frame {\n};\n}  // namespace\n"};
  const SourceFile elsewhere{
      "d.hpp", "namespace limpet::layers {\nstruct Frame {\n}  // namespace limpet::layers\n"};
  EXPECT_THAT(TypesDefinedTwice({a, b, hidden, elsewhere}),
              ElementsAre("limpet::Frame: a.hpp b.hpp"));
  EXPECT_THAT(TypesDefinedTwice({a, hidden, elsewhere}), IsEmpty());
}

TEST(CitedCode, OfEveryPageIsInTheFileThatItNames) {
  const std::vector<SourceFile> files = TreeFiles();
  for (const auto& page :
       std::filesystem::directory_iterator(std::filesystem::path(LIMPET_SOURCE_DIR) / "docs")) {
    if (page.path().extension() == ".md") {
      EXPECT_THAT(WronglyCited(ReadAll(page.path()), files), IsEmpty()) << page.path();
    }
  }
}

TEST(CitedCode, OfTheLessonsIsOfEveryExample) {
  const std::string page =
      ReadAll(std::filesystem::path(LIMPET_SOURCE_DIR) / "docs" / "examples.md");
  for (const SourceFile& file : TreeFiles()) {
    if (file.path.starts_with("tests/examples/")) {
      EXPECT_THAT(page, HasSubstr("<!-- " + file.path + " -->"));
    }
  }
}

TEST(CitedCode, ThatTheFileLacksIsComplainedAbout) {
  const SourceFile file{"a.cpp", "int a = 1;\nint b = 2;\n"};
  EXPECT_THAT(WronglyCited("<!-- a.cpp -->\n```cpp\nint b = 2;\n```\n", {file}), IsEmpty());
  EXPECT_THAT(WronglyCited("<!-- a.cpp -->\n```cpp\nint b = 3;\n```\n", {file}),
              ElementsAre(HasSubstr("a.cpp: does not hold")));
  EXPECT_THAT(WronglyCited("<!-- b.cpp -->\n```cpp\nint b = 2;\n```\n", {file}),
              ElementsAre(HasSubstr("no such file")));
}

TEST(TestSubjects, AreFilesOfTheLibraryThatTheTestsFolderNames) {
  EXPECT_THAT(TestsWithoutSubject(TreeFiles()), IsEmpty());
}

std::vector<std::string> Complaints(const std::string& test) {
  return TestsWithoutSubject({{"share/limpet/wire/packet_codec.cpp", ""},
                              {"share/limpet/wire/records/time.hpp", ""},
                              {"tests/support/torn_disk.hpp", ""},
                              {"tests/unit/wire/made_packets.hpp", ""},
                              {"apps/limpet/command_line.cpp", ""},
                              {"apps/limpet/verbs/check.cpp", ""},
                              {"apps/pMap/map_app.cpp", ""},
                              {"share/limpet/map/map_diff.cpp", ""},
                              {"tests/unit/" + test + "_test.cpp", ""}});
}

TEST(TestSubjects, AreNamedFirst) {
  for (const char* test :
       {"wire/packet_codec", "wire/packet_codec_captures", "wire/packet_codec_properties",
        "wire/time", "wire/torn_disk", "cli/command_line", "cli/check_verb", "cli/check_safety",
        "pMap/map_app", "pMap/map_app_faults"}) {
    EXPECT_THAT(Complaints(test), IsEmpty());
  }
}

TEST(TestSubjects, AreOneFileEach) {
  EXPECT_THAT(Complaints("wire/packet"),
              ElementsAre("tests/unit/wire/packet_test.cpp: is of no file of `wire`"))
      << "part of a name";
  for (const char* test : {"wire/packet_codecs", "wire/wire_captures", "wire/short_records",
                           "wire/captures", "wire/made_packets", "core/time", "cli/verbs",
                           "cli/checks", "pMap/map_diff", "map/map_app"}) {
    EXPECT_THAT(Complaints(test), ElementsAre(HasSubstr("is of no file of"))) << test;
  }
}

TEST(LayerTable, EndsWithItsMarkdownTable) {
  EXPECT_EQ(SmallTable().size(), 3U);
  EXPECT_THAT(SmallTable().at("core").may_use, IsEmpty());
  EXPECT_THAT(SmallTable().at("estimation").may_use, ElementsAre("core", "estimation"));
}

TEST(Layers, FindsAnEdgeThatTheTableLacks) {
  EXPECT_THAT(
      Check({{"share/limpet/core/a.hpp", "\n#include \"limpet/vision/b.hpp\"\n"}}),
      ElementsAre("share/limpet/core/a.hpp:2: limpet/vision/b.hpp: `core` may not use `vision`"));
  EXPECT_THAT(Check({{"estimation/change/a.cpp", "# include \"limpet/vision/b.hpp\""}}),
              ElementsAre(HasSubstr("`estimation` may not use `vision`")));
}

TEST(Layers, FindsALibraryWithoutARow) {
  EXPECT_THAT(Check({{"share/limpet/extra/a.hpp", "#include \"limpet/core/units.hpp\"\n"}}),
              ElementsAre(HasSubstr("`extra` has no row")));
}

TEST(Layers, KeepsAppsApart) {
  const std::string text = "#include \"apps/pNav/nav_app.hpp\"\n";
  EXPECT_THAT(Check({{"apps/pMap/a.cpp", text}}), ElementsAre(HasSubstr("another app")));
  EXPECT_THAT(Check({{"apps/limpet/a.cpp", text}}), ElementsAre(HasSubstr("another app")));
  EXPECT_THAT(Check({{"apps/pNav/b.cpp", text}}), IsEmpty());
}

TEST(Layers, LetsNothingButTestsIncludeTests) {
  const std::string text = "#include \"tests/support/temporary_folder.hpp\"\n";
  EXPECT_THAT(Check({{"apps/limpet/a.cpp", text}}), ElementsAre(HasSubstr("but tests")));
  EXPECT_THAT(Check({{"tests/unit/a.cpp", text}}), IsEmpty());
}

TEST(Layers, KeepsThirdPartyHeadersOutOfWhatOthersReach) {
  const SourceFile header{"share/limpet/vision/a.hpp", "#include <opencv2/core.hpp>\n"};
  const SourceFile between{"share/limpet/vision/b.hpp", "#include \"limpet/vision/a.hpp\"\n"};
  EXPECT_THAT(Check({header, {"share/limpet/vision/a.cpp", between.text}}), IsEmpty());
  EXPECT_THAT(
      Check({header, between, {"apps/uSimCamera/c.cpp", "#include \"limpet/vision/b.hpp\"\n"}}),
      ElementsAre(HasSubstr("vision/a.hpp:1: opencv2/core.hpp: OpenCV stays out")));
}

TEST(Layers, KeepsThirdPartyToTheLibrariesWhoseRowNamesIt) {
  EXPECT_THAT(Check({{"share/limpet/core/a.cpp", "#include <opencv2/core.hpp>\n"}}),
              ElementsAre(HasSubstr("`core` may not use OpenCV")));
}

TEST(Layers, WantsIncludePathsFromTheRoot) {
  EXPECT_THAT(Check({{"share/limpet/core/a.cpp", "#include \"a.hpp\"\n"}}),
              ElementsAre(HasSubstr("from the repository root")));
}

}  // namespace
}  // namespace limpet::layers
