// SPDX-License-Identifier: MIT
// What `limpet check` makes of other people's missions, apps and behaviors.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(CheckOfOthers, NotesWhatBelongsToOtherPeoplesApps) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "alpha.moos";
  std::ofstream(moos) << "ServerPort = 9000\nCommunity = alpha\nProcessConfig = ANTLER\n{\n"
                         "  Run = MOOSDB\n  Run = pHelmIvP\n  Run = pRealm\n  Run = uSimMarine\n}\n"
                         "ProcessConfig = pHelmIvP\n{\n  behaviors = a.bhv\n}\n"
                         "ProcessConfig = uPokeDB\n{\n  x = 1\n}\n";
  const Checked mission = Check({moos.string()});
  EXPECT_EQ(mission.exit_code, kOk) << mission.text;
  EXPECT_THAT(mission.text, HasSubstr("note: pHelmIvP: is no app of Limpet's"));
  const fs::path bhv = folder.path() / "a.bhv";
  std::ofstream(bhv) << "initialize DEPLOY = false\nBehavior = BHV_ConvoyV21\n{\n  name = c\n  "
                        "radius = 2\n}\n";
  const Checked behaviors = Check({bhv.string()});
  EXPECT_EQ(behaviors.exit_code, kOk) << behaviors.text;
  EXPECT_THAT(behaviors.text, HasSubstr("a.bhv:2: note: BHV_ConvoyV21"));
}

TEST(CheckOfOthers, NotesWhatOurHelmCouldNotRunInPlaceOfTheStockOne) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.bhv") << "Behavior = BHV_AvdColregsV99\n{\n  name = avoid\n}\n";
  const auto check = [&](const std::string& helm) {
    const fs::path moos = folder.path() / "a.moos";
    std::ofstream(moos)
        << "Community = alpha\nProcessConfig = ANTLER\n{\n  Run = MOOSDB\n  Run = " << helm
        << "\n  Run = uSimMarineV22\n}\nProcessConfig = " << helm
        << "\n{\n  Behaviors = a.bhv\n  Domain = course:0:359:360\n  Domain = "
           "speed:0:4:41\n  verbose = terse\n  ok_skew = any\n  start_in_drive = true\n}\n";
    return Check({moos.string()});
  };
  const Checked stock = check("pHelmIvP");
  EXPECT_EQ(stock.exit_code, kOk) << stock.text;
  EXPECT_THAT(stock.text, HasSubstr("no behavior `BHV_AvdColregsV99`"));
  EXPECT_THAT(stock.text, HasSubstr("verbose"));
  EXPECT_THAT(stock.text, Not(HasSubstr("ok_skew"))) << "that is heeded";
  const Checked ours = check("pHelm");
  EXPECT_EQ(ours.exit_code, kUsage) << ours.text;
}

TEST(CheckOfOthers, NotesOtherPeoplesAppsWhoseNamesAreNearOneOfOurs) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "a.moos";
  const auto check = [&moos](const std::string& database) {
    std::ofstream(moos) << "ServerPort = 9000\nCommunity = alpha\nLatOrigin = 44\nLongOrigin = 9\n"
                        << "ProcessConfig = ANTLER\n{\n  Run = " << database
                        << "\n  Run = iNav\n  Run = uLog\n  Run = pNodeReporter\n}\n"
                           "ProcessConfig = iMap\n{\n  x = 1\n}\n";
    return Check({moos.string()});
  };
  const Checked others = check("MOOSDB");
  EXPECT_EQ(others.exit_code, kOk) << others.text;
  EXPECT_THAT(others.text, HasSubstr("note: iNav: is no app of Limpet's: its block is not checked; "
                                     "nearest known: `pNav`"));
  EXPECT_THAT(others.text, HasSubstr("note: ProcessConfig: `iMap`"));
  EXPECT_EQ(check("LimpetDB").exit_code, kUsage) << "in a mission of ours it is a slip";
}

TEST(CheckOfOthers, ChecksOthersMissionsAlsoWithoutWhatTheyIncludeFromElsewhere) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "a.moos";
  const auto check = [&moos](const std::string& database, const std::string& port) {
    std::ofstream(moos) << "ServerPort = " << port
                        << "\n#include plug_location.moos\nCommunity = alpha\n"
                           "ProcessConfig = ANTLER\n{\n  Run = "
                        << database << "\n  Run = uSimMarine\n}\n  #include plug_more.moos";
    return Check({moos.string()});
  };
  const Checked others = check("MOOSDB", "9000");
  EXPECT_EQ(others.exit_code, kOk) << others.text;
  EXPECT_THAT(others.text,
              HasSubstr("a.moos:2: note: #include: `plug_location.moos` is not found"));
  EXPECT_THAT(others.text, HasSubstr("a.moos:9: note: #include: `plug_more.moos` is not found"));
  EXPECT_THAT(check("MOOSDB", "many").text, HasSubstr("ServerPort: `many`")) << "the rest is read";
  const Checked ours = check("LimpetDB", "9000");
  EXPECT_EQ(ours.exit_code, kUsage);
  EXPECT_THAT(ours.text, HasSubstr("a.moos:2: #include: `plug_location.moos` is not found"));
}

TEST(CheckOfOthers, NotesLinesThatMoosPassesOverInTheLaunchersBlock) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "a.moos";
  const auto check = [&moos](const std::string& database) {
    std::ofstream(moos) << "ServerPort = 9000\nCommunity = alpha\nProcessConfig = ANTLER\n{\n"
                        << "  ---------\n  [x]\n  Run: pX\n  Run = " << database
                        << "\n  Run = uSimMarine\n}\n}\n";
    return Check({moos.string()});
  };
  const Checked others = check("MOOSDB");
  EXPECT_EQ(others.exit_code, kOk) << others.text;
  EXPECT_THAT(others.text, HasSubstr("a.moos:7: note: ANTLER: `Run: pX` is neither a comment"));
  EXPECT_THAT(others.text, HasSubstr("a.moos:11: note: ANTLER: a `}` too many"));
  EXPECT_THAT(others.text, HasSubstr("note: uSimMarine: is no app of Limpet's"))
      << "the rest is still said";
  EXPECT_THAT(others.text, Not(HasSubstr("would not"))) << "our launcher passes over them, too\n"
                                                        << others.text;
  EXPECT_EQ(check("LimpetDB").exit_code, kUsage) << "a mission of ours has no such lines";
}

TEST(CheckOfOthers, NotesWhatAStockNodeReporterIsToldAndOursWouldRefuse) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "meta_vehicle.moos";
  const auto check = [&moos](const std::string& apps, const std::string& length) {
    std::ofstream(moos) << "ServerPort = 9000\nCommunity = alpha\nLatOrigin = $(LAT)\n"
                           "LongOrigin = 9.86\nProcessConfig = ANTLER\n{\n"
                        << apps << "  Run = pNodeReporter\n}\nProcessConfig = pNodeReporter\n{\n"
                        << "  platform_length = " << length << "\n  term_reporting = true\n}\n";
    return Check({moos.string()});
  };
  const Checked stock = check("  Run = MOOSDB\n  Run = uSimMarine\n", "$(VLENGTH)");
  EXPECT_EQ(stock.exit_code, kOk) << stock.text;
  EXPECT_THAT(stock.text, HasSubstr("note: $(LAT): undefined macro"));
  EXPECT_THAT(stock.text, HasSubstr("note: $(VLENGTH): undefined macro"));
  EXPECT_THAT(stock.text, HasSubstr("note: term_reporting: unknown key"));
  EXPECT_THAT(stock.text, Not(HasSubstr("is not allowed")));
  EXPECT_EQ(check("  Run = LimpetDB\n", "4").exit_code, kUsage) << "ours stays checked strictly";
}

TEST(CheckOfOthers, NotesStockBehaviorsAndRefusesSlips) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  const auto check = [&bhv](const std::string& behavior) {
    std::ofstream(bhv) << "Behavior = " << behavior << "\n{\n  name = a\n}\n";
    return Check({bhv.string()});
  };
  for (const char* stock :
       {"BHV_RStationKeep", "BHV_ZigLeg", "BHV_AvoidObstacles", "BHV_Agent", "BHV_OpRegionV26",
        "BHV_GoToDepthX", "BHV_StationKeepV2", "BHV_MyLoiter"}) {
    EXPECT_EQ(check(stock).exit_code, kOk) << stock;
  }
  const Checked slip = check("BHV_StationKep");
  EXPECT_EQ(slip.exit_code, kUsage);
  EXPECT_THAT(slip.text, HasSubstr("nearest known: `BHV_StationKeep`"));
}

TEST(CheckOfOthers, NamesTheNearestOfAnUnknownBehaviorIfThereIsANearOne) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  const auto check = [&bhv](const std::string& behavior) {
    std::ofstream(bhv) << "Behavior = " << behavior << "\n{\n  name = a\n}\n";
    return Check({bhv.string()}).text;
  };
  EXPECT_THAT(check("BHV_AvdColregsV19"), HasSubstr("nearest known: `BHV_AvoidObstacle`"));
  EXPECT_THAT(check("BHV_HeadingBias"), HasSubstr("nearest known: `BHV_ConstantHeading`"));
  for (const char* far :
       {"BHV_Shadow", "BHV_Scout", "BHV_Convoy", "BHV_Trail", "BHV_SecurityFence"}) {
    const std::string text = check(far);
    EXPECT_THAT(text, Not(HasSubstr("nearest known"))) << "a name that is far off misleads";
    EXPECT_THAT(text, HasSubstr("none that is known has a name near it; `limpet describe` lists"));
  }
  EXPECT_THAT(check("BHV_MinAltitude"), HasSubstr("it is called `BHV_MinAltitudeX`"));
}

TEST(CheckOfOthers, RefusesANameInLettersThatNoHelmTakesAndSaysTheRightOne) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  for (const char* name : {"BHV_waypoint", "BHV_WayPoint", "bhv_Waypoint", "Waypoint"}) {
    std::ofstream(bhv) << "Behavior = " << name << "\n{\n  name = a\n}\n";
    const Checked checked = Check({bhv.string()});
    EXPECT_EQ(checked.exit_code, kUsage) << checked.text;
    EXPECT_THAT(checked.text, HasSubstr("a.bhv:1: Behavior: no behavior `" + std::string(name) +
                                        "`; it is called `BHV_Waypoint`: case counts"));
  }
}

TEST(CheckOfOthers, NotesABehaviorBesideAMissionOfOtherPeopleThatIsNearOneOfOurs) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "a.bhv";
  std::ofstream(bhv) << "Behavior = BHV_WaypointX\n{\n  name = a\n}\n";
  EXPECT_EQ(Check({bhv.string()}).exit_code, kOk) << "nobody says whose it is: it may be a variant";
  const auto mission_of = [&folder](const std::string& database) {
    std::ofstream(folder.path() / "a.moos")
        << "ServerPort = 9000\nCommunity = alpha\nProcessConfig = ANTLER\n{\n  Run = " << database
        << "\n  Run = pHelmIvP\n}\n";
  };
  mission_of("MOOSDB");
  const Checked others = Check({bhv.string()});
  EXPECT_EQ(others.exit_code, kOk) << others.text;
  EXPECT_THAT(others.text, HasSubstr("note: BHV_WaypointX: is no behavior of Limpet's: not "
                                     "checked; nearest known: `BHV_Waypoint`"));
  mission_of("LimpetDB");
  EXPECT_EQ(Check({bhv.string()}).exit_code, kUsage);
}

TEST(CheckOfOthers, NotesWhatAStockPShareWouldHaveToSayToBeOurs) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "shoreside.moos";
  const auto check = [&moos](const std::string& database) {
    std::ofstream(moos) << "ServerPort = 9000\nCommunity = shoreside\nProcessConfig = ANTLER\n{\n"
                        << "  Run = " << database << "\n  Run = pShare\n  Run = pMarineViewer\n}\n"
                        << "ProcessConfig = pShare\n{\n  input = route=localhost:9200\n}\n";
    return Check({moos.string()});
  };
  const Checked stock = check("MOOSDB");
  EXPECT_EQ(stock.exit_code, kOk) << stock.text;
  EXPECT_THAT(stock.text, HasSubstr("allow_plain_routes = true"));
  EXPECT_EQ(check("LimpetDB").exit_code, kUsage) << "a mission of ours needs a key";
}

TEST(CheckOfOthers, NestedTextOfAnAcousticModemIsANoteAndInABlockOfOursAnError) {
  const MissionCopy mission;
  mission.Apply({PlugOf("pDetect"), "ProcessConfig = pDetect\n{\n",
                 "ProcessConfig = pAcommsHandler\n{\n  driver_cfg {\n    modem_id = 3\n    fsk { "
                 "rate: 0 }\n  }\n}\nProcessConfig = pDetect\n{\n"});
  const Checked foreign = mission.Run();
  EXPECT_EQ(foreign.exit_code, kOk) << foreign.text;
  EXPECT_THAT(foreign.text, HasSubstr("note: "));
  mission.Apply(
      {PlugOf("pDetect"), "detector = color_shape", "detector = color_shape\n  x {\n  }"});
  EXPECT_EQ(mission.Run().exit_code, kUsage);
}

TEST(CheckOfOthers, TakesASurveyWithOtherPeoplesDriversDatabaseAndLogger) {
  const MissionCopy mission;
  fs::remove(mission.path() / "scenario.yaml");
  std::ofstream(mission.path() / "my_drivers.moos") << "Run = iEverything\n";
  mission.Apply({"mission.moos", "#include plug_survey",
                 "#define OWN_COMMUNITY\n#define DRIVERS my_drivers.moos\n#include plug_survey"});
  const Checked checked = mission.Run();
  EXPECT_EQ(checked.exit_code, kOk) << checked.text;
  EXPECT_THAT(checked.text, HasSubstr("no problems"));
  EXPECT_THAT(checked.text, HasSubstr("note: iEverything: is no app of Limpet's"));
}

TEST(CheckOfOthers, ANameOfMillionsOfLettersTakesNoTime) {
  const TemporaryFolder folder;
  const fs::path bhv = folder.path() / "long.bhv";
  std::string name = "BHV_";
  for (int i = 0; i < 700'000; ++i)
    name += "Abc";
  std::ofstream(bhv) << "Behavior = " << name << "\n{\n  name = x\n}\n";
  EXPECT_THAT(Check({bhv.string()}).text, HasSubstr("is no behavior of Limpet's"));
}

/// A mission of other people's whose helm's place ours takes.
class CheckOfStockMission : public ::testing::Test {
 protected:
  [[nodiscard]] Checked Run(const std::string& helm_line, const std::string& behaviors,
                            const std::string& run = "uSimMarineV22") const {
    std::ofstream(folder_.path() / "a.bhv") << behaviors;
    const fs::path moos = folder_.path() / "a.moos";
    std::ofstream(moos) << "ServerPort = 9000\nCommunity = alpha\nProcessConfig = ANTLER\n{\n"
                        << "  Run = MOOSDB\n  Run = pHelmIvP\n  Run = " << run
                        << "\n}\nProcessConfig = pHelmIvP\n{\n  " << helm_line
                        << "\n  domain = course:0:359:360\n  domain = speed:0:4:41\n}\n";
    return Check({moos.string()});
  }
  TemporaryFolder folder_;
};

constexpr const char* kWaypoint = "Behavior = BHV_Waypoint\n{\n  name = way\n  points = 0,9\n  ";

TEST_F(CheckOfStockMission, SaysInTheEndIfOursWouldNotRunIt) {
  const std::string good = std::string(kWaypoint) + "speed = 2\n}\n";
  const Checked fine = Run("behaviors = a.bhv", good);
  EXPECT_EQ(fine.exit_code, kOk) << fine.text;
  EXPECT_THAT(fine.text, Not(HasSubstr("would not"))) << "ours runs it";
  struct Bad {
    std::string helm_line, behaviors, run;
  };
  for (const Bad& bad :
       {Bad{"behaviors = a.bhv", good + "Behavior = BHV_Trail\n{\n  name = t\n}\n", "pX"},
        Bad{"behaviors = a.bhv", std::string(kWaypoint) + "endflag = DONE\n}\n", "pX"},
        Bad{"behaviors = a.bhv", good + "Behavior = BHV_Waypoint\n{\n  = =\n", "pX"},
        Bad{"behaviours = a.bhv", good, "pX"}, Bad{"behaviors = a.bhv", good, "Deep"}}) {
    const Checked checked = Run(bad.helm_line, bad.behaviors, bad.run);
    EXPECT_EQ(checked.exit_code, kOk) << "the stock programs may take it\n" << checked.text;
    EXPECT_THAT(checked.text, HasSubstr("[Limpet's own would not start with this]"))
        << bad.helm_line << bad.behaviors;
    EXPECT_THAT(checked.text, HasSubstr("Limpet's own programs would not run it"));
  }
}

TEST_F(CheckOfStockMission, WithALineThatMoosDropsRunsInOursToo) {
  const Checked checked = Run("just words\n  behaviors = a.bhv", std::string(kWaypoint) + "}\n");
  EXPECT_EQ(checked.exit_code, kOk) << checked.text;
  EXPECT_THAT(checked.text, HasSubstr("note: pHelmIvP: `just words` is neither a comment (//) nor "
                                      "`key = value`; ignored, as by MOOS"));
  EXPECT_THAT(checked.text, Not(HasSubstr("would not")));
}

TEST_F(CheckOfStockMission, OfAPShareWithoutAKeySaysSo) {
  const fs::path moos = folder_.path() / "share.moos";
  std::ofstream(moos) << "ServerPort = 9000\nProcessConfig = ANTLER\n{\n  Run = pShare ~ "
                         "ShareA\n  Run = pShare ~ ShareB\n}\nProcessConfig = ShareA\n{\n  "
                         "Output = X->localhost:9021\n}\n";
  const Checked share = Check({moos.string()});
  EXPECT_EQ(share.exit_code, kOk) << "MOOS's runs it, also without a Community\n" << share.text;
  EXPECT_THAT(share.text, HasSubstr("note: Community: this global is missing"));
  EXPECT_THAT(share.text, HasSubstr("Limpet's own programs would not run it"));
}

TEST(CheckOfOthers, TakesAFileOfSeveralTaggedPlugsForAPiece) {
  const TemporaryFolder folder;
  const fs::path moos = folder.path() / "uav_plugs.moos";
  std::ofstream(moos) << "<tag><origin_warp>\nMOOSTimeWarp = 1\n\n<tag><pShare>\nProcessConfig = "
                         "pShare\n{\n  input = route = localhost:9200\n}\n";
  EXPECT_EQ(Check({moos.string()}).exit_code, kOk) << Check({moos.string()}).text;
}

TEST(CheckOfOthers, LooksForBehaviorsWhereTheMissionBesideABehaviorFileSays) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.bhv") << "Behavior = BHV_Timer\n{\n  name = t\n}\n";
  std::ofstream(folder.path() / "a.moos")
      << "Community = a\nProcessConfig = ANTLER\n{\n  Run = LimpetDB\n  Run = pHelm\n}\n"
         "ProcessConfig = pHelm\n{\n  behaviors = a.bhv\n  behavior_path = elsewhere\n}\n";
  for (const char* name : {"a.bhv", "a.moos"}) {
    const Checked checked = Check({(folder.path() / name).string()});
    EXPECT_EQ(checked.exit_code, kUsage) << checked.text;
    EXPECT_THAT(checked.text, HasSubstr("a.moos:10: behavior_path: `")) << "it is not there";
    EXPECT_THAT(checked.text,
                Not(::testing::ContainsRegex("says it for all[^\n]*says it for all")));
  }
}

}  // namespace
}  // namespace limpet
