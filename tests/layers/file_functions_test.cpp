// SPDX-License-Identifier: MIT
#include "tests/layers/file_functions.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/tree_files.hpp"

namespace limpet::layers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

SourceFile Hiding(const std::string& path, const std::string& function) {
  return {path, "namespace limpet {\nnamespace {\n\n" + function + "\n}  // namespace\n"};
}

TEST(FileFunctions, AreEachOfOneFileOfTheirLibrary) {
  EXPECT_THAT(FunctionsOfTwoFiles(TreeFiles()), IsEmpty());
}

TEST(FileFunctions, OfOneNameInTwoFilesAreComplainedAboutWhateverTheyTake) {
  const SourceFile page = Hiding("report/page.cpp", "std::string Place(const Place& at) {\n}\n");
  EXPECT_THAT(
      FunctionsOfTwoFiles({page, Hiding("report/lines.cpp", "const Row& Place(\n    int a) {\n}")}),
      ElementsAre("report/Place: page.cpp lines.cpp"));
  EXPECT_THAT(FunctionsOfTwoFiles({page, Hiding("map/lines.cpp", "int Place(int a) {\n}")}),
              IsEmpty())
      << "another library";
  EXPECT_THAT(FunctionsOfTwoFiles({page, Hiding("report/lines.cpp", "  return Place(3);")}),
              IsEmpty())
      << "a call";
  EXPECT_THAT(FunctionsOfTwoFiles({page, Hiding("report/lines.cpp", "using P = int Place(int);")}),
              IsEmpty());
}

TEST(FileFunctions, ThatAHeaderOfTheirLibraryDeclaresAreComplainedAbout) {
  const SourceFile header{"map/json.hpp",
                          "namespace limpet {\n[[nodiscard]] Json JsonOf(const Map& map);\n"};
  EXPECT_THAT(FunctionsOfTwoFiles({header, Hiding("map/a.cpp", "Json JsonOf(bool is_on) {\n}")}),
              ElementsAre("map/JsonOf: json.hpp a.cpp"));
}

TEST(FileFunctions, OfOneFileMayBeOverloads) {
  EXPECT_THAT(
      FunctionsOfTwoFiles({Hiding("a/a.cpp", "int Twice(int a) {\n}\nlong Twice(long a) {\n}")}),
      IsEmpty());
}

}  // namespace
}  // namespace limpet::layers
