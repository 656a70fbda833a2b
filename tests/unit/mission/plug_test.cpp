// SPDX-License-Identifier: MIT
#include "limpet/mission/plug.hpp"

#include <chrono>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/mission/mission_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

/// A folder of fragments that lives as long as a test.
class PlugTest : public ::testing::Test {
 protected:
  void Write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  /// Non-empty lines of the expansion joined by `|`.
  std::string Expand(const std::string& text) {
    result_ = ExpandPlugs(text, folder_ / "in.moos", options_);
    std::string joined;
    for (const TextLine& line : result_.lines) {
      joined += line.text.empty() ? "" : line.text + "|";
    }
    return joined;
  }
  std::string ErrorOf(const std::string& text) {
    try {
      Expand(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
  PlugOptions options_;
  PlugResult result_;
};

TEST_F(PlugTest, ReplacesMacrosInEveryForm) {
  EXPECT_EQ(Expand("#define M abc\n#define E\n$(M) %(M) $(U=d) $(E=d)x $(E:=d) %(U:=d)\n"),
            "abc ABC d x d D|");
}

TEST_F(PlugTest, ReplacesMacrosInsideValues) {
  EXPECT_EQ(Expand("#define A $(B)1\n#define B 2\n$(A) $(X=$(A))\n"), "21 21|");
}

TEST_F(PlugTest, TakesMacrosFromOutsideAndLetsTheFileOverride) {
  options_.macros = {{"A", "1"}, {"B", "2"}};
  EXPECT_EQ(Expand("#define $(B) 3\n$(A)$(B)\n"), "13|");
  EXPECT_EQ(result_.warnings.size(), 1U);
}

TEST_F(PlugTest, LeavesALineWithAnUndefinedMacroWhollyAlone) {
  EXPECT_EQ(Expand("#define A 1\n$(A)$(NONE)\n"), "$(A)$(NONE)|");
  EXPECT_EQ(result_.warnings.size(), 1U);
  options_.undefined = PlugOptions::Undefined::kKeepMacro;
  EXPECT_EQ(Expand("#define A 1\n$(A)$(NONE)\n"), "1$(NONE)|");
}

TEST_F(PlugTest, RefusesUndefinedMacrosWhenStrictButNotInComments) {
  options_.undefined = PlugOptions::Undefined::kRefuse;
  EXPECT_THAT(ErrorOf("#define ALTITUDE 1\n// $(NONE)\nx = $(ALTITDE)\n"),
              HasSubstr("in.moos:3: $(ALTITDE): undefined macro; did you mean `ALTITUDE`?"));
}

TEST_F(PlugTest, KeepsRunTimeMacrosAndOtherHashLines) {
  EXPECT_EQ(Expand("$[OSX]\n#pragma x\n# text\n"), "$[OSX]|#pragma x|# text|");
}

TEST_F(PlugTest, ChoosesByConditions) {
  options_.macros = {{"A", "x"}, {"B", "x"}, {"C", "y"}};
  EXPECT_EQ(Expand("#ifdef A\n1\n#else\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef A x\n1\n#endif\n#ifdef A z\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef A B\n1\n#endif\n#ifdef A C\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef N || C y\n1\n#endif\n#ifdef N && A\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef N || A && B\n1\n#else\n2\n#endif\n"), "2|");
  EXPECT_EQ(Expand("#ifndef N M\n1\n#endif\n#ifndef N A\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef N\n1\n#elseifdef A\n2\n#elseifdef B\n3\n#else\n4\n#endif\n"), "2|");
}

TEST_F(PlugTest, NestsConditions) {
  options_.macros = {{"A", ""}};
  EXPECT_EQ(
      Expand("#ifdef N\n#ifdef A\n1\n#else\n2\n#endif\n#else\n\t#ifdef A\n3\n#endif\n#endif\n"),
      "3|");
}

TEST_F(PlugTest, RefusesUnbalancedConditions) {
  EXPECT_THAT(ErrorOf("\n#ifdef A\n"), HasSubstr("in.moos:2: #ifdef: has no #endif"));
  EXPECT_THAT(ErrorOf("#else\n"), HasSubstr("in.moos:1: #else: has no #ifdef"));
}

TEST_F(PlugTest, IncludesFragmentsThatShareMacros) {
  Write("a.plug", "#define DEPTH 5\nfrom_a\n");
  EXPECT_EQ(Expand("#define NAME a\n#include $(NAME).plug\n#include \"a.plug\"\n$(DEPTH)\n"),
            "from_a|from_a|5|");
}

TEST_F(PlugTest, SearchesTheGivenFoldersAfterItsOwn) {
  Write("more/b.plug", "b\n");
  EXPECT_THAT(ErrorOf("#include b.plug\n"),
              HasSubstr("in.moos:1: #include: `b.plug` is not found beside this file, and no "
                        "folder called `plugs` is beside or above it or the program"));
  options_.search_folders = {folder_ / "more"};
  EXPECT_EQ(Expand("#include b.plug\n"), "b|");
}

TEST_F(PlugTest, RefusesLoops) {
  Write("a.plug", "#include b.plug\n");
  Write("b.plug", "#include a.plug\n");
  EXPECT_THAT(ErrorOf("#include a.plug\n"),
              HasSubstr("b.plug:1: #include: `a.plug` includes itself"));
}

TEST_F(PlugTest, TakesOneTaggedSection) {
  Write("t.plug", "top\n<tag> <one>\n1\n#define M 2\n<tag> two\n2\n<tag> <one>\n3\n");
  EXPECT_EQ(Expand("#include t.plug <one>\n"), "1|3|");
  EXPECT_EQ(Expand("#include t.plug <two>\n"), "2|");
  EXPECT_EQ(Expand("#include t.plug\n"), "top|1|2|3|");
}

TEST_F(PlugTest, EndsEveryFileWithAnEmptyLine) {
  EXPECT_EQ(ExpandPlugs("a\n", "in", {}).lines.size(), 2U);
  EXPECT_EQ(ExpandPlugs("a\n", "in", {}).lines[1].text, "");
}

TEST_F(PlugTest, RemembersWhereEveryLineCameFrom) {
  Write("a.plug", "\nx = bad\n");
  Expand("first\n#include a.plug\nlast\n");
  EXPECT_THAT(result_.lines[2].where.file, HasSubstr("a.plug"));
  EXPECT_EQ(result_.lines[2].where.line, 2);
  EXPECT_EQ(result_.lines[4].where.line, 3);
}

TEST_F(PlugTest, StopsMacrosThatGrowWithoutEnd) {
  EXPECT_THAT(ErrorOf("#define A $(A)$(A)xxxxxxxxxxxxxxxx\n$(A)\n"),
              HasSubstr("its macros grow beyond 32 KiB in a line"));
}

/// Well below a second on a slow machine with sanitizers; without bounds each of these takes
/// minutes.
constexpr double kSoonS = 1.0;

TEST_F(PlugTest, EndsMacrosThatGrowInAnyShapeSoonAndSaysWhere) {
  const std::string chain = [] {
    std::string text = "#define A0 xxxxxxxx\n";
    for (int i = 1; i < 40; ++i) {
      text += fmt::format("#define A{0} $(A{1})$(A{1})\n", i, i - 1);
    }
    return text + "$(A39)\n";
  }();
  const std::vector<std::string> shapes{
      "#define A $(A)$(A)\n\n$(A)\n",
      "#define A $(B)$(B)\n#define B $(A)$(A)\n$(A)\n",
      "#define A %(A)%(A)\n$(A)\n",
      "$(A=$(B=$(A)$(A)))\n#define B $(A=$(B)$(B))\n#define A $(B)$(B)\n$(A)\n",
      chain,
      "#define A $(A)$(A)\n#include $(A)\n",
  };
  for (const std::string& shape : shapes) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(ErrorOf(shape), testing::ContainsRegex("in.moos:[0-9]+: .*its macros grow beyond"))
        << shape;
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
              kSoonS)
        << shape;
  }
}

TEST_F(PlugTest, AMacroThatHoldsOnlyItselfIsSaidAndLeft) {
  EXPECT_EQ(Expand("#define V $(V)\nname = $(V)\n"), "name = $(V)|");
  ASSERT_EQ(result_.warnings.size(), 1U);
  EXPECT_THAT(result_.warnings[0].Format(), HasSubstr("in.moos:2: $(V): after 100 rounds"));
}

TEST_F(PlugTest, ManyLongLinesEndAtTheBoundOfTheWholeTemplate) {
  std::string text = "#define A " + std::string(30'000, 'x') + "\n";
  for (int i = 0; i < 400; ++i) {
    text += "$(A)\n";
  }
  EXPECT_THAT(ErrorOf(text), HasSubstr("its macros grow beyond"));
}

TEST_F(PlugTest, EndsInclusionsThatMultiplySoonAndSaysWhere) {
  Write("leaf.plug", "x\n");
  std::string before = "leaf.plug";
  for (int i = 0; i < 30; ++i) {
    const std::string name = fmt::format("level{}.plug", i);
    Write(name, fmt::format("#include {0}\n#include {0}\n", before));
    before = name;
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(ErrorOf("#include " + before + "\n"),
              testing::ContainsRegex("plug:[0-9]+: #include: more than 1000 inclusions"));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            kSoonS);
}

TEST_F(PlugTest, AMacroSetToNothingCountsAsUndefinedButForAnd) {
  options_.macros = {{.name = "E", .value = "", .is_set_empty = true}, {.name = "M", .value = ""}};
  EXPECT_EQ(Expand("#ifdef E\n1\n#else\n2\n#endif\n"), "2|");
  EXPECT_EQ(Expand("#ifdef M\n1\n#else\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifndef E\n1\n#else\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifndef M\n1\n#else\n2\n#endif\n"), "2|");
  EXPECT_EQ(Expand("#ifdef E || M\n1\n#else\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef E && M\n1\n#else\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef M word\n1\n#else\n2\n#endif\n"), "2|");
  EXPECT_EQ(Expand("#ifdef E word\n1\n#else\n2\n#endif\n"), "1|");
  ASSERT_EQ(result_.warnings.size(), 1U);
  EXPECT_THAT(result_.warnings[0].text, HasSubstr("`E` is empty and `word` no macro with a value"));
}

TEST_F(PlugTest, ANameWhoseValueWasAskedForCountsAsEmptyInTheRestOfACondition) {
  EXPECT_EQ(Expand("#ifdef U && U word\n1\n#else\n2\n#endif\n"), "2|");
  EXPECT_EQ(Expand("#ifdef U word && U\n1\n#else\n2\n#endif\n"), "1|");
  EXPECT_EQ(Expand("#ifdef U\n1\n#else\n2\n#endif\n"), "2|");
}

TEST_F(PlugTest, SectionMarkersNeedNoBlank) {
  Write("t.plug", "top\n<tag><one>\n1\n#define M 2\n\t<tag><two>\n2\n<tag><one>\n3\n");
  EXPECT_EQ(Expand("#include t.plug <one>\n"), "1|3|");
  EXPECT_EQ(Expand("#include t.plug <two>\t\n"), "2|");
  EXPECT_EQ(Expand("#include t.plug\n"), "top|1|2|3|");
  EXPECT_EQ(Expand("<tag><x>\nonly text\n"), "only text|");
}

TEST_F(PlugTest, AFileTakesASectionOfItself) {
  Write("in.moos", "#include in.moos <s>\nbody\n<tag><s>\nsection\n");
  EXPECT_EQ(Expand("#include in.moos <s>\nbody\n<tag><s>\nsection\n"), "section|body|section|");
}

TEST_F(PlugTest, EmptyLinesAtTheEndAreNsplugs) {
  const auto lines_of = [](std::string_view text, const std::string& tag) {
    PlugOptions options;
    options.tag = tag;
    return ExpandPlugs(text, "in", options).lines.size();
  };
  EXPECT_EQ(lines_of("a", ""), 1U);
  EXPECT_EQ(lines_of("", ""), 1U);
  EXPECT_EQ(lines_of("<tag><a>\n1\n<tag><b>\n2\n", "a"), 1U);
  EXPECT_EQ(lines_of("<tag><a>\n1\n<tag><b>\n2\n", "b"), 2U);
}

TEST_F(PlugTest, ALineWithWhatLooksLikeAMacroIsLeftWholly) {
  EXPECT_EQ(Expand("#define A 1\n$(A) 50%(about)\n"), "$(A) 50%(about)|");
  EXPECT_EQ(Expand("#define A   1 \t 2\n$(A)\n"), "1 2|");
}

TEST_F(PlugTest, ReadsMacroFiles) {
  Write("macros.txt", "# comment\nA = 1\n// more\nB = $(A)2\nA = 9\n");
  options_.macro_files = {folder_ / "macros.txt"};
  EXPECT_EQ(Expand("$(A) $(B)\n"), "1 12|");
  EXPECT_EQ(result_.warnings.size(), 1U);
}

TEST_F(PlugTest, ErrorsOfAMissionNameTheFragment) {
  Write("bad.plug", "ok = 1\nnot a pair\n");
  try {
    static_cast<void>(ParseMission("ProcessConfig = pA\n{\n#include bad.plug\n}\n",
                                   (folder_ / "m.moos").string()));
    FAIL() << "must not parse";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bad.plug:2: pA: `not a pair`"));
  }
}

}  // namespace
}  // namespace limpet
