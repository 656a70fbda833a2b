// SPDX-License-Identifier: MIT
#include "limpet/mission/mission_file.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/params.hpp"
#include "limpet/mission/behavior_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

std::string MissionErrorsOf(const std::string& text) {
  try {
    static_cast<void>(ParseMission(text, "m.moos"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(MissionFile, ReadsGlobalsWithoutCase) {
  const MissionFile mission = ParseMission("  communitY = alpha  // the vehicle\n", "m.moos");
  EXPECT_EQ(mission.Global("Community"), "alpha");
}

TEST(MissionFile, DropsBlanksInsideGlobals) {
  EXPECT_EQ(ParseMission("LatOrigin = 43. 72\t1\n", "m.moos").Global("LatOrigin"), "43.721");
}

TEST(MissionFile, KeepsBlanksOfQuotedGlobals) {
  EXPECT_EQ(ParseMission("Title = \"a // b\" // c\n", "m.moos").Global("title"), "a // b");
}

TEST(MissionFile, KeepsBlocksInFileOrderWithTheirLines) {
  const MissionFile mission =
      ParseMission("ProcessConfig = pA\n{\n  x = 1 2\n  X = 3\n} trailing text\n", "m.moos");
  const ConfigBlock* block = mission.Block("PA");
  ASSERT_NE(block, nullptr);
  ASSERT_EQ(block->entries.size(), 2U);
  EXPECT_EQ(block->entries[0].value, "1 2");
  EXPECT_EQ(block->entries[1].where.line, 4);
}

TEST(MissionFile, AcceptsABraceOnTheHeaderLine) {
  const MissionFile mission = ParseMission("processconfig=pA {\nx=1\n}\n", "m.moos");
  EXPECT_NE(mission.Block("pA"), nullptr);
  ASSERT_EQ(mission.warnings.size(), 1U);
  EXPECT_EQ(mission.warnings[0].Format(),
            "m.moos:1: pA: MOOS overlooks a block whose `{` stands on this line");
}

TEST(MissionFile, FindsABlockWhateverWhiteSpaceItsHeaderHas) {
  const MissionFile mission = ParseMission(
      "Process Config = pA\n{\nx = 1\n}\n PROCESS\tCONFIG=p B\n{\n}\nA = 2\n", "m.moos");
  ASSERT_NE(mission.Block("pA"), nullptr);
  EXPECT_EQ(mission.Block("pA")->Find("x")->value, "1");
  EXPECT_NE(mission.Block("pB"), nullptr);
  EXPECT_EQ(mission.Global("A"), "2");
  EXPECT_TRUE(mission.warnings.empty());
}

TEST(MissionFile, UsesOnlyTheFirstBlockOfAName) {
  const MissionFile mission =
      ParseMission("ProcessConfig = pA\n{\nx=1\n}\nProcessConfig = pA\n{\nx=2\n}\n", "m.moos");
  EXPECT_EQ(mission.Block("pA")->Find("x")->value, "1");
  EXPECT_EQ(mission.warnings.size(), 1U);
}

TEST(MissionFile, KeepsQuotesInTheHelmsBlockOnly) {
  const MissionFile mission = ParseMission(
      "ProcessConfig = pHelmIvP\n{\nx=\"a\"\n}\nProcessConfig = pB\n{\nx=\"a\"\n}\n", "m.moos");
  EXPECT_EQ(mission.Block("pHelmIvP")->Find("x")->value, "\"a\"");
  EXPECT_EQ(mission.Block("pB")->Find("x")->value, "a");
}

TEST(MissionFile, DropsEntriesWithoutValueUnlessBracketed) {
  const MissionFile mission =
      ParseMission("ProcessConfig = pA\n{\nx =\nleft_context[a] =\n}\n", "m.moos");
  ASSERT_EQ(mission.Block("pA")->entries.size(), 1U);
  EXPECT_EQ(mission.Block("pA")->entries[0].key, "left_context[a]");
}

TEST(MissionFile, ListsLaunchesWithNamesAndOptions) {
  const MissionFile mission = ParseMission(
      "ProcessConfig = ANTLER\n{\n  Run = MOOSDB @ NewConsole = false\n"
      "  Run = bin/pHelm @ NewConsole = false, ExtraProcessParams = HP ~ pHelm_Standby\n"
      "  Run = /opt/pNav\n}\n",
      "m.moos");
  ASSERT_EQ(mission.launches.size(), 3U);
  EXPECT_EQ(mission.launches[0].moos_name, "MOOSDB");
  EXPECT_EQ(mission.launches[0].options[0].value, "false");
  EXPECT_EQ(mission.launches[1].binary, "bin/pHelm");
  EXPECT_EQ(mission.launches[1].moos_name, "pHelm_Standby");
  EXPECT_EQ(mission.launches[1].options[1].key, "ExtraProcessParams");
  EXPECT_EQ(mission.launches[2].moos_name, "pNav");
}

TEST(MissionFile, ReplacesVariablesByTheLastDefinition) {
  const MissionFile mission = ParseMission(
      "define: HOST = alpha\nServerHost = ${HOST}\nProcessConfig = pA\n{\nHOST = bravo\n}\n",
      "m.moos");
  EXPECT_EQ(mission.Global("ServerHost"), "bravo");
  EXPECT_EQ(mission.Global("define:HOST"), "");
}

TEST(MissionFile, NamesAnUndefinedVariable) {
  EXPECT_THAT(MissionErrorsOf("\nServerHost = ${LIMPET_NO_SUCH}\n"),
              HasSubstr("m.moos:2: ${LIMPET_NO_SUCH}"));
}

TEST(MissionFile, LeavesTheBareNameOfAnUndefinedVariableToThoseWhoseBlockIsReadStrictly) {
  const MissionFile mission = ReadMission(
      "ServerHost = ${LIMPET_NO_SUCH}\nProcessConfig = ANTLER\n{\n  Run = pHelmIvP\n  Run = pX\n}\n"
      "ProcessConfig = pHelmIvP\n{\n}\nProcessConfig = pX\n{\n}\n",
      "m.moos", {});
  EXPECT_EQ(mission.Global("ServerHost"), "LIMPET_NO_SUCH");
  EXPECT_EQ(mission.Block("ANTLER")->problems.size(), 1U);
  EXPECT_EQ(mission.Block("pX")->problems.size(), 1U);
  EXPECT_TRUE(mission.Block("pHelmIvP")->problems.empty());
  EXPECT_EQ(NotesOf(mission, [](const std::string&) { return false; }).size(), 1U) << "said once";
}

TEST(MissionFile, ReadsLinesOfAnyLengthAndCarriageReturns) {
  const std::string value(5000, 'x');
  const MissionFile mission = ParseMission("A = " + value + "\r\nB = 2\r\n", "m.moos");
  EXPECT_EQ(mission.Global("A"), value);
  EXPECT_EQ(mission.Global("B"), "2");
  EXPECT_EQ(mission.warnings.size(), 1U);
}

TEST(MissionFile, IgnoresBannersAsMoosDoes) {
  EXPECT_TRUE(ParseMission("/* === banner ===\n * a = b\n */\n", "m.moos").globals.empty());
}

TEST(MissionFile, ReportsEveryBadLineOfABlock) {
  const std::string errors = MissionErrorsOf("ProcessConfig = pA\n{\nfoo\nx=1\n#bar\n}\n");
  EXPECT_THAT(errors, HasSubstr("m.moos:3: pA: `foo` is neither a comment"));
  EXPECT_THAT(errors, HasSubstr("m.moos:5: pA: `#bar`"));
}

TEST(MissionFile, ReportsAMissingClosingBrace) {
  EXPECT_THAT(MissionErrorsOf("ProcessConfig = pA\n{\nx=1\nProcessConfig = pB\n{\n}\n"),
              HasSubstr("m.moos:4: pA: the block has no closing `}`"));
  EXPECT_THAT(MissionErrorsOf("ProcessConfig = pA\n{\nx=1\n"), HasSubstr("m.moos:1: pA"));
}

TEST(MissionFile, ReportsAMissingOpeningBraceAndGoesOn) {
  const std::string errors = MissionErrorsOf("ProcessConfig = pA\nx = 1\n}\n");
  EXPECT_THAT(errors, HasSubstr("m.moos:2: pA: `{` must come before"));
}

/// As a process or command reads a file: the blocks of others may hold anything.
MissionFile Read(const std::string& text) { return ReadMission(text, "m.moos", {}); }

TEST(MissionFile, KeepsABlockOfNestedForeignTextAndGoesOnBehindIt) {
  const MissionFile mission = Read(
      "ProcessConfig = pAcommsHandler\n{\n  AppTick = 10\n  common {\n    log { verbosity: 3 }\n"
      "    # comment of theirs\n    name = \"a}b\"\n  }\n  driver\n  {\n    id: 1\n  }\n}\n"
      "ProcessConfig = pNav\n{\n  AppTick = 5\n}\nServerPort = 9001\n");
  ASSERT_NE(mission.Block("pAcommsHandler"), nullptr);
  EXPECT_EQ(mission.Block("pAcommsHandler")->Find("AppTick")->value, "10");
  EXPECT_EQ(mission.Block("pNav")->Find("AppTick")->value, "5");
  EXPECT_TRUE(mission.Block("pNav")->problems.empty());
  EXPECT_EQ(mission.Global("ServerPort"), "9001");
}

TEST(MissionFile, NotesNestedTextOnceWithItsLineAndLeavesItToTheBlocksApp) {
  const MissionFile mission =
      Read("ProcessConfig = pModem\n{\n  driver {\n    a { b { c: 1 } }\n  }\n  rate 5\n}\n");
  const std::vector<ConfigProblem>& problems = mission.Block("pModem")->problems;
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_THAT(problems[0].Format(), HasSubstr("m.moos:3: pModem: a `{` inside the block"));
  EXPECT_THAT(problems[1].Format(), HasSubstr("m.moos:6: pModem: `rate 5` is neither"));
  const std::vector<ConfigProblem> notes =
      NotesOf(mission, [](const std::string&) { return false; });
  ASSERT_EQ(notes.size(), 1U) << "of somebody else's block the first says enough";
  EXPECT_THAT(notes[0].Format(), HasSubstr("(and 1 more of its lines)"));
  EXPECT_TRUE(NotesOf(mission, [](const std::string&) { return true; }).empty());
}

TEST(MissionFile, ProblemsOfOurOwnBlockAreErrorsToItsApp) {
  struct Params {
    double rate = 1.0;
    void Describe(ParamCollector& visit) { visit("rate", rate, "rate"); }
  };
  const MissionFile mission = Read("ProcessConfig = pNav\n{\n  rate = 2\n  pose {\n  }\n}\n");
  try {
    static_cast<void>(ReadParams<Params>(*mission.Block("pNav")));
    FAIL() << "must not be read";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("m.moos:4: pNav: a `{` inside the block"));
  }
}

TEST(MissionFile, ForeignTextThatNeverEndsStopsAtTheNextBlock) {
  const MissionFile mission =
      Read("ProcessConfig = pModem\n{\n  a {\n  b: 1\nProcessConfig = pNav\n{\n  AppTick = 5\n}\n");
  EXPECT_EQ(mission.Block("pNav")->Find("AppTick")->value, "5");
  EXPECT_EQ(mission.Block("pModem")->problems.size(), 2U);
}

TEST(MissionFile, ABraceTooManyIsAProblemOfTheBlockBeforeIt) {
  const MissionFile mission = Read("ProcessConfig = pNav\n{\n  a = 1\n}\n  b = 2\n}\n");
  ASSERT_EQ(mission.Block("pNav")->problems.size(), 1U);
  EXPECT_THAT(mission.Block("pNav")->problems[0].Format(), HasSubstr("m.moos:6: pNav: a `}` too"));
}

TEST(MissionFile, NestedTextOutsideOfBlocksIsNotTakenForGlobals) {
  const MissionFile mission = Read("modem {\n  ServerPort = 1\n}\nServerPort = 9002\n");
  EXPECT_EQ(mission.Global("ServerPort"), "9002");
  EXPECT_EQ(mission.warnings.size(), 1U);
}

TEST(MissionFile, ABraceOutsideOfBlocksThatNeverEndsSwallowsNoGlobals) {
  EXPECT_THAT(MissionErrorsOf("modem {\nServerPort = 1\nProcessConfig = pA\n{\n}\n"),
              HasSubstr("m.moos:1: {: outside of blocks"));
}

TEST(MissionFile, LaunchesWhatTheLaunchersBlockSaysBesideLinesThatMoosPassesOver) {
  const MissionFile mission =
      Read("ProcessConfig = ANTLER\n{\n  -------\n  Run: pNav\n  Run = MOOSDB\n}\n}\n");
  ASSERT_EQ(mission.launches.size(), 1U);
  EXPECT_EQ(mission.launches[0].binary, "MOOSDB");
  EXPECT_EQ(mission.Block("ANTLER")->problems.size(), 3U);
}

TEST(MissionFile, VariablesThatStandForTooMuchEndWithTheirLine) {
  std::string text = "A = " + std::string(100'000, 'x') + "\n";
  for (int i = 0; i < 200; ++i) {
    text += "B = ${A}\n";
  }
  EXPECT_THAT(MissionErrorsOf(text), HasSubstr(": ${A}: the file's variables stand for more than"));
}

TEST(MissionFile, LoadsTheIverMissionWhole) {
  const std::filesystem::path file =
      std::filesystem::path(LIMPET_SOURCE_DIR) /
      "../shared/data/iver_umassd/simulation/iver__18_12_2016_____17_26_26/"
      "iver__18_12_2016_____17_26_26._moos";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no shared data";
  }
  const MissionFile mission = LoadMission(file);
  EXPECT_EQ(mission.Global("Community"), "iver");
  EXPECT_EQ(mission.launches.size(), 9U);
  EXPECT_NE(mission.Block("pHelmIvP"), nullptr);
}

TEST(MissionFile, LoadsOurOwnMissionsWithTheirPlugs) {
  const MissionFile mission =
      LoadMission(std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1/mission.moos");
  const ConfigBlock* nav = mission.Block("pNav");
  ASSERT_NE(nav, nullptr);
  ASSERT_NE(nav->Find("camera_fov_across_deg"), nullptr);
  EXPECT_EQ(nav->Find("camera_fov_across_deg")->value, "80");
  EXPECT_THAT(nav->Find("camera_width_px")->where.file, HasSubstr("feelhippo.yaml"));
  EXPECT_TRUE(mission.warnings.empty());
}

TEST(MissionFile, GivesABlockTheGlobalsThatItTakesAndDoesNotSay) {
  const MissionFile mission = ParseMission(
      "ProcessConfig = ANTLER\n{\n  Run = pMap ~ eye\n}\n"
      "ProcessConfig = pSurvey\n{\n  altitude_m = 5\n}\n"
      "ProcessConfig = pHelm\n{\n}\n"
      "ProcessConfig = pLog\n{\n}\n"
      "ProcessConfig = eye\n{\n}\n"
      "survey_altitude_m = 4\nsurvey_altitude_m = 3\nobject_radius_m = 0.5\n",
      "m.moos");
  EXPECT_EQ(mission.Block("pSurvey")->Find("altitude_m")->value, "5") << "its own";
  const ConfigEntry* taken = mission.Block("pHelm")->Find("survey_altitude_m");
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(taken->value, "4") << "the first counts, as with every global";
  EXPECT_EQ(taken->where.line, 18);
  EXPECT_TRUE(mission.Block("pLog")->entries.empty());
  EXPECT_NE(mission.Block("eye")->Find("object_radius_m"), nullptr) << "it is pMap's";
}

TEST(MissionFile, OfOursFindsTheProgramsPlugsFromWhereverItIsCopiedTo) {
  namespace fs = std::filesystem;
  const TemporaryFolder elsewhere;
  for (const char* name : {"table1", "basin", "rough"}) {
    const fs::path source = fs::path(LIMPET_SOURCE_DIR) / "missions" / name;
    fs::copy(source, elsewhere.path() / name);
    const MissionFile copied = LoadMission(elsewhere.path() / name / "mission.moos");
    EXPECT_TRUE(copied.warnings.empty()) << name;
    EXPECT_EQ(copied.launches.size(), LoadMission(source / "mission.moos").launches.size());
    EXPECT_GE(LoadBehaviors(elsewhere.path() / name / "mission.bhv").behaviors.size(), 5U);
  }
}

TEST(MissionFile, OfAVehicleWithItsOwnDriversLaunchesWhatSurveysAlone) {
  const MissionFile mission = ParseMission(
      "#define OWN_COMMUNITY\n#include plug_ANTLER.moos\n",
      (std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1/mission.moos").string());
  for (const LaunchEntry& launch : mission.launches) {
    EXPECT_EQ(launch.binary.front(), 'p') << launch.binary;
    EXPECT_NE(launch.binary, "pLog");
  }
  EXPECT_EQ(mission.launches.size(), 8U);
}

}  // namespace
}  // namespace limpet
