// SPDX-License-Identifier: MIT
// What `limpet check` takes, and how it says what it found.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/check.hpp"
#include "limpet/core/config.hpp"
#include "tests/support/mission_copy.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

const fs::path kMissions = fs::path(LIMPET_SOURCE_DIR) / "missions";

TEST(CheckVerbOfFolders, FindsNothingWrongWithOurMissions) {
  for (const fs::directory_entry& mission : fs::directory_iterator(kMissions)) {
    const Checked checked = Check({mission.path().string()});
    EXPECT_EQ(checked.exit_code, kOk) << mission.path() << "\n" << checked.text;
  }
}

TEST(CheckVerbOfFiles, TakesAMissionFileAndABehaviorFile) {
  EXPECT_THAT(Check({(kMissions / "table1/mission.moos").string()}).text,
              testing::MatchesRegex("energy: [^\n]+\nno problems\n"));
  EXPECT_EQ(Check({(kMissions / "table1/mission.bhv").string()}).text, "no problems\n");
  EXPECT_EQ(Check({(kMissions / "two_communities/shore.moos").string()}).exit_code, kOk);
}

TEST(CheckVerbOfFiles, NotesKeysOfExistingMissionsThatHaveNoEffect) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  std::ofstream(bhv) << "Behavior = BHV_Waypoint\n{\n  points = 1,2\n  draw_path_loop = true\n"
                        "  build_info = uniform_piece=discrete\n}\n";
  const Checked behaviors = Check({bhv.string()});
  EXPECT_EQ(behaviors.exit_code, kOk) << behaviors.text;
  EXPECT_THAT(behaviors.text,
              HasSubstr("a.bhv:4: note: draw_path_loop: has no effect in BHV_Waypoint"));
  EXPECT_THAT(behaviors.text, HasSubstr("a.bhv:5: note: build_info: has no effect"));
}

TEST(CheckVerbOfFiles, NotesValuesThatStockHelmsCutToARangeAndWhatTheyAreTakenAs) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  std::ofstream(bhv) << "Behavior = BHV_StationKeep\n{\n  station_pt = 1,2\n  swing_time = 90\n}\n";
  const Checked behaviors = Check({bhv.string()});
  EXPECT_EQ(behaviors.exit_code, kOk) << behaviors.text;
  EXPECT_THAT(behaviors.text,
              HasSubstr("a.bhv:4: note: swing_time: `90` is taken as 60; allowed: 0 to 60 s"));
}

TEST(CheckVerbOfFiles, RefusesToLeadAHelmThatDoesNotHearOrIsNotThere) {
  const TemporaryFolder folder;
  fs::copy(kMissions / "led_helm", folder.path() / "m");
  fs::copy(kMissions / "basin", folder.path() / "basin");
  fs::copy(kMissions.parent_path() / "plugs", folder.path() / "plugs");
  const auto check_with = [&](const fs::path& file, const std::string& from,
                              const std::string& to) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    std::ofstream(file) << changed.replace(at, from.size(), to);
    const Checked checked = Check({(folder.path() / "m").string()});
    std::ofstream(file) << text;
    return checked;
  };
  const fs::path led = folder.path() / "m/vehicle.bhv";
  const Checked deaf = check_with(led, "= SURVEY_WAY\n", "= SURVEY_WYA\n");
  EXPECT_EQ(deaf.exit_code, kUsage) << deaf.text;
  EXPECT_THAT(deaf.text, HasSubstr("plug_pHelm.moos:"));
  EXPECT_THAT(deaf.text, HasSubstr("lead: no BHV_Waypoint of pHelmIvP takes updates in "
                                   "`SURVEY_WAY`; the nearest that one takes them in: "
                                   "`SURVEY_WYA`"));
  const fs::path antler = folder.path() / "plugs/plug_ANTLER.moos";
  const Checked alone = check_with(antler, "  Run = pHelmIvP ", "  // Run = pHelmIvP ");
  EXPECT_EQ(alone.exit_code, kUsage) << alone.text;
  EXPECT_THAT(alone.text, HasSubstr("pHelmIvP is not launched: nobody would steer"));
  const fs::path helm = folder.path() / "plugs/plug_pHelm.moos";
  const Checked mute = check_with(helm, "  lead        = SURVEY_WAY\n", "");
  EXPECT_THAT(mute.text, HasSubstr("lead_depth: says nothing without `lead`"));
  const Checked slip = check_with(helm, "turning_radius_m", "turning_radius_n");
  EXPECT_EQ(slip.exit_code, kUsage) << "our own block stays checked strictly\n" << slip.text;
}

TEST(CheckVerbOfFiles, NotesThatATemplateIsNotYetExpanded) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "meta_vehicle.moos";
  std::ofstream(moos) << "ServerPort = $(VPORT)\nCommunity = $(VNAME)\nMOOSTimeWarp = $(WARP)\n"
                         "ProcessConfig = ANTLER\n{\n  Run = MOOSDB\n  Run = pShare\n  Run = "
                         "uFldNodeBroker\n}\nProcessConfig = pShare\n{\n  input = route = "
                         "$(IP_ADDR):$(PSHARE_PORT)\n}\n";
  const Checked checked = Check({moos.string()});
  EXPECT_EQ(checked.exit_code, kOk) << checked.text;
  EXPECT_THAT(checked.text, HasSubstr("note: $(VPORT): undefined macro"));
  EXPECT_THAT(checked.text, Not(HasSubstr("is not allowed")))
      << "what follows from that is no news";
}

TEST(CheckVerbOfFiles, RefusesAConditionWhoseComplaintSpeaksOfAVariable) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  const auto check = [&bhv](const std::string& condition) {
    std::ofstream(bhv) << "Behavior = BHV_Waypoint\n{\n  points = 1,2\n  condition = " << condition
                       << "\n}\n";
    return Check({bhv.string()});
  };
  const Checked bad = check("DEPLOY = true and RETURN = false");
  EXPECT_EQ(bad.exit_code, kUsage) << bad.text;
  EXPECT_THAT(bad.text, HasSubstr("a.bhv:4: condition: "));
  EXPECT_THAT(bad.text, Not(HasSubstr("undefined macro"))) << "there is none in the file";
  const Checked macro = check("DEPLOY = $(GO) and RETURN = false");
  EXPECT_EQ(macro.exit_code, kOk) << macro.text;
  EXPECT_THAT(macro.text, HasSubstr("note: $(GO): undefined macro"));
}

TEST(CheckVerbOfFiles, SaysWhatElseIsWrongWithABehaviorWhoseNameIsAMacro) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "meta_vehicle.bhv";
  std::ofstream(bhv) << "Behavior = BHV_Loiter\n{\n  name = w_$(V)\n  speeed = 1\n"
                        "  polygon = 1,2\n}\nBehavior = BHV_Timer\n{\n  name = w_$(V)\n}\n";
  const Checked checked = Check({bhv.string()});
  EXPECT_EQ(checked.exit_code, kUsage) << checked.text;
  EXPECT_THAT(checked.text, HasSubstr("a_vehicle.bhv:3: note: $(V): undefined macro"));
  EXPECT_THAT(checked.text, HasSubstr("a_vehicle.bhv:4: speeed: unknown key in BHV_Loiter"));
  EXPECT_THAT(checked.text, HasSubstr("a_vehicle.bhv:5: polygon: "));
  EXPECT_THAT(checked.text, HasSubstr("a_vehicle.bhv:9: note: $(V): undefined macro"));
}

TEST(CheckVerbOfFiles, RefusesANamedPipeInsteadOfWaitingForIt) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "mission.moos";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const fs::path& named : {pipe, folder.path()}) {
    try {
      static_cast<void>(Check({named.string()}));
      FAIL() << "must not be read";
    } catch (const UsageError& error) {
      static_cast<void>(::testing::internal::GetCapturedStdout());
      EXPECT_THAT(error.what(), HasSubstr("mission.moos: is no plain file"));
    }
  }
  const fs::path bhv = folder.path() / "a.bhv";
  std::ofstream(bhv) << "Behavior = BHV_Timer\n{\n  name = t\n}\n";
  EXPECT_EQ(Check({bhv.string()}).exit_code, kOk) << "the pipe beside it is passed over";
}

TEST(CheckVerbOfFiles, PassesOverAByteOrderMarkWithANote) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  std::ofstream(bhv) << "\xEF\xBB\xBF"
                        "Behavior = BHV_Timer\n{\n  name = t\n}\n";
  const Checked checked = Check({bhv.string()});
  EXPECT_EQ(checked.exit_code, kOk) << checked.text;
  EXPECT_THAT(checked.text, HasSubstr("a.bhv:1: note: begins with a byte order mark"));
}

TEST(CheckVerbOfFiles, NotesAMacroInUpperCaseAsItDoesAnother) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "meta_vehicle.bhv";
  std::ofstream(bhv) << "Behavior = BHV_Waypoint\n{\n  name = %(VNAME)_x\n  points = 1,2\n"
                        "  speed = %(SPEED)\n  capture_radius = %(RADIUS:=3)\n}\n";
  const Checked checked = Check({bhv.string()});
  EXPECT_EQ(checked.exit_code, kOk) << checked.text;
  EXPECT_THAT(checked.text, HasSubstr("meta_vehicle.bhv:3: note: %(VNAME): undefined macro"));
  EXPECT_THAT(checked.text, HasSubstr("meta_vehicle.bhv:5: note: %(SPEED): undefined macro"));
  EXPECT_THAT(checked.text, Not(HasSubstr("RADIUS"))) << "its default counts";
}

TEST(CheckVerbOfFiles, TakesMacrosWithADefaultAsNsplugDoes) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "meta_vehicle.bhv";
  std::ofstream(bhv) << "Behavior = BHV_Waypoint\n{\n  name = go\n  points = $(START)\n"
                        "  speed = $(SPEED:=1.4)\n}\n";
  const Checked good = Check({bhv.string()});
  EXPECT_EQ(good.exit_code, kOk) << good.text;
  EXPECT_THAT(good.text, HasSubstr("meta_vehicle.bhv:4: note: $(START): undefined macro"));
  std::ofstream(bhv) << "Behavior = BHV_Waypoint\n{\n  name = go\n  points = 1,2\n"
                        "  speed = $(SPEED:=fast)\n}\n";
  EXPECT_EQ(Check({bhv.string()}).exit_code, kUsage) << "the default is what counts";
}

TEST(CheckVerbOfFiles, ExpectsNothingOfALoggerThatOnlyListens) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "a.moos";
  const auto check = [&moos](const std::string& others) {
    std::ofstream(moos) << "ServerPort = 9000\nCommunity = alpha\nLatOrigin = 44\nLongOrigin = 9\n"
                        << "ProcessConfig = ANTLER\n{\n  Run = LimpetDB\n  Run = pNodeReporter\n"
                        << others << "}\n";
    return Check({moos.string()});
  };
  const Checked alone = check("  Run = pLogger\n");
  EXPECT_EQ(alone.exit_code, kOk) << alone.text;
  EXPECT_THAT(alone.text, HasSubstr("must come from a program that is not launched here: "
                                    "pNodeReporter needs it"));
  const Checked simulated = check("  Run = pLogger\n  Run = uSimMarine\n");
  EXPECT_EQ(simulated.exit_code, kOk) << simulated.text;
  EXPECT_THAT(simulated.text, HasSubstr("must come from uSimMarine: pNodeReporter needs it"));
}

TEST(CheckVerb, NotesASensorThatNobodyHereWrites) {
  const std::string table1 = (kMissions / "table1").string();
  const Checked other = Check({table1, "--set", "pNav.dvl_variable=NUCLEUS_DVL"});
  EXPECT_EQ(other.exit_code, kOk) << other.text;
  EXPECT_THAT(other.text, HasSubstr("dvl_variable: no app that is launched here writes "
                                    "NUCLEUS_DVL"));
  EXPECT_THAT(Check({table1}).text, Not(HasSubstr("no app that is launched here")));
}

TEST(CheckVerbOfFiles, SaysOnceOfABlockThatItIsNoListOfSettings) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "plug_modem.moos";
  std::ofstream(moos) << "ProcessConfig = pAcommsHandler\n{\n  modem_id: 3\n  rate: 0\n"
                         "  mac: slotted\n}\n";
  const Checked modem = Check({moos.string()});
  EXPECT_EQ(modem.exit_code, kOk);
  EXPECT_THAT(modem.text, HasSubstr("(and 2 more of its lines)"));
  EXPECT_THAT(modem.text, Not(HasSubstr("slotted")));
}

TEST(CheckVerbOfFiles, TakesFilesOfADatumAndLinesBehindAHash) {
  const TemporaryFolder folder;
  const fs::path datum = folder.path() / "spezia.moos";
  std::ofstream(datum) << "LatOrigin = 44.09\nLongOrigin = 9.86\n";
  EXPECT_EQ(Check({datum.string()}).exit_code, kOk) << "it is for others to include";
  const fs::path moos = folder.path() / "a.moos";
  std::ofstream(moos) << "ServerPort = 9000\nCommunity = alpha\nProcessConfig = ANTLER\n{\n"
                         "  # consoles: none\n  Run = MOOSDB\n  Run = pNodeReporter\n"
                         "  Run = uSimMarine\n}\nLatOrigin = 44.09\nLongOrigin = 9.86\n";
  const Checked hash = Check({moos.string()});
  EXPECT_EQ(hash.exit_code, kOk) << hash.text;
  EXPECT_THAT(hash.text, HasSubstr("a.moos:5: note: #: is no comment in mission files"));
  EXPECT_THAT(hash.text, HasSubstr("must come from uSimMarine: pNodeReporter needs it"));
  std::ofstream(datum) << "ServerPort = 9000\nCommunity = alpha\n";
  EXPECT_EQ(Check({datum.string()}).exit_code, kUsage) << "a vehicle, but nothing to launch";
}

TEST(CheckVerbOfFiles, RefusesAMisspeltBehaviorAndABadParameterOfABehaviorFile) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  std::ofstream(bhv) << "Behavior = BHV_HoldAltitud\n{\n  altitude_m = 3\n}\nBehavior = "
                        "BHV_ConstantDepth\n{\n  peakwidth = wide\n}\n";
  const Checked checked = Check({bhv.string()});
  EXPECT_EQ(checked.exit_code, kUsage);
  EXPECT_THAT(checked.text, HasSubstr("nearest known: `BHV_HoldAltitude`"));
  EXPECT_THAT(checked.text, HasSubstr("a.bhv:7: peakwidth: `wide` is not allowed"));
  EXPECT_THAT(checked.text, HasSubstr("2 problems\n"));
}

TEST(CheckVerbOfFiles, RefusesAnEmptyFile) {
  const TemporaryFolder folder;
  for (const char* name : {"mission.moos", "a.bhv"}) {
    std::ofstream(folder.path() / name).flush();
    const Checked checked = Check({(folder.path() / name).string()});
    EXPECT_EQ(checked.exit_code, kUsage) << name;
    EXPECT_THAT(checked.text, HasSubstr(name));
  }
}

TEST(CheckVerbOfFiles, SaysThatThereIsNoSuchFile) {
  EXPECT_THROW(static_cast<void>(RunCheck(std::vector<std::string>{"/no/such/mission"})),
               UsageError);
}

TEST(CheckOutput, IsOneLineEachByFileAndLineWithACount) {
  const MissionCopy mission;
  mission.Apply({"mission.moos", "MOOSTimeWarp = 1", "MOOSTimeWarp = 9000"});
  mission.Apply({PlugOf("pSurvey"), "COVERAGE_TARGET=0.975", "COVERAGE_TARGET=1.5"});
  mission.Apply({"../plugs/plug_survey.bhv", "radius_m  = 1", "radius_m  = -1"});
  const Checked checked = mission.Run();
  EXPECT_EQ(checked.exit_code, kUsage);
  const std::vector<std::string> lines = Split(checked.text, '\n');
  ASSERT_EQ(lines.size(), 5U) << checked.text;
  // Which file is first depends on where the test runs: from afar plugs have absolute paths.
  EXPECT_THAT(std::vector(lines.begin(), lines.begin() + 3),
              UnorderedElementsAre(HasSubstr("plug_pSurvey.moos:57: coverage_target"),
                                   HasSubstr("plug_survey.bhv:146: radius_m"),
                                   HasSubstr("mission.moos:7: MOOSTimeWarp")));
  EXPECT_EQ(lines[3], "3 problems");
}

TEST(CheckOutput, HoldsNothingThatATerminalObeys) {
  const MissionCopy mission;
  mission.Apply(
      {PlugOf("pDetect"), "detector = color_shape", "detector = \x1b]0;owned\x07\x1b[2J"});
  const Checked checked = mission.Run();
  EXPECT_EQ(checked.exit_code, kUsage);
  EXPECT_THAT(checked.text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(checked.text, HasSubstr("\\x1b"));
}

TEST(CheckOutput, AsJsonTellsKindsApart) {
  const MissionCopy mission;
  mission.Apply({"mission.bhv", "#include", "#define ALTITUDE 3\n#include"});
  const Checked checked = Check({mission.path().string(), "--json"});
  EXPECT_EQ(checked.exit_code, kRefused);
  const auto found = nlohmann::json::parse(checked.text);
  EXPECT_TRUE(found.at("syntax").empty());
  EXPECT_EQ(found.at("geometry").at(0).at("key"), "altitude_m");
  EXPECT_TRUE(found.at("notes").is_array());
}

}  // namespace
}  // namespace limpet
