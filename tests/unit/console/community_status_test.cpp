// SPDX-License-Identifier: MIT
#include "limpet/console/community_status.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Message Said(const std::string& name, Value value) {
  return {.name = name,
          .value = std::move(value),
          .time = Seconds(0),
          .source = "",
          .source_aux = "",
          .community = ""};
}
Message Said(const std::string& name, const char* text) {
  return Said(name, Value(std::string(text)));
}

MissionFile Mission() {
  return ParseMission(
      "ProcessConfig = ANTLER\n{\n  Run = MOOSDB @ NewConsole = false\n  Run = pNav\n"
      "  Run = pHelmIvP ~ pHelm\n}\n",
      "mission.moos");
}

TEST(CommunityStatus, TellsWhoIsThereWhoIsMissingAndWhoIsAGuest) {
  CommunityStatus status;
  status.Expect(Mission());
  status.Ignore("uStatus_1");
  status.Hear(Said("PROC_SUMMARY", "pNav:SUBSCRIBED=,A,B,PUBLISHED=,C"));
  status.Hear(Said("PROC_SUMMARY", "uScope_2:SUBSCRIBED=,PUBLISHED="));
  status.Hear(Said("PROC_SUMMARY", "uStatus_1:SUBSCRIBED=,A,PUBLISHED="));
  status.Hear(Said("DB_QOS", "pNav=0.25:3:0.1:0.5,uScope_2=0:1:1:1,"));
  EXPECT_EQ(PlainText(StatusTable(status.Rows())),
            "PROCESS   STATE  READS  WRITES  DELAY ms  RESTARTS  NOTE\n"
            "pNav      up     2      1       0.2       -\n"
            "pHelm     AWOL   -      -       -         -\n"
            "uScope_2  guest  0      0       0.0       -\n");
  EXPECT_THAT(MissingOf(status.Rows()), ElementsAre("pHelm"));
}

TEST(CommunityStatus, PassesOnWhatAppsSayOfThemselves) {
  CommunityStatus status;
  status.Hear(Said("PROC_SUMMARY", "pNav:SUBSCRIBED=,PUBLISHED="));
  status.Hear(Said("PNAV_WARNINGS", "DVL_STALE: no bottom lock"));
  status.Hear(Said("PNAV_STATUS", "AppErrorFlag=true,Uptime=3"));
  EXPECT_EQ(status.Rows().at(0).warnings, "DVL_STALE: no bottom lock; reports an error");
  status.Hear(Said("PNAV_WARNINGS", "none"));
  status.Hear(Said("PNAV_WARNINGS", Value(3.0)));
  EXPECT_EQ(status.Rows().at(0).warnings, "reports an error");
}

constexpr const char* kLaunched =
    "app=LimpetDB,state=running,restarts=0,last=,database=true # app=pNav,state=waiting,restarts=2,"
    "last=was killed by signal 9 (Killed),database=false";

TEST(CommunityStatus, ListensToTheLauncherWithoutAMission) {
  CommunityStatus status;
  status.Hear(Said("PROC_SUMMARY", "pLaunch:SUBSCRIBED=,PUBLISHED=,PLAUNCH_STATUS"));
  status.Hear(Said("PLAUNCH_STATUS", kLaunched));
  EXPECT_EQ(PlainText(StatusTable(status.Rows())),
            "PROCESS  STATE  READS  WRITES  DELAY ms  RESTARTS  NOTE\n"
            "pNav     AWOL   -      -       -         2         pLaunch: waiting; it was killed by "
            "signal 9 (Killed)\n"
            "pLaunch  guest  0      1       -         -\n");
}

TEST(CommunityStatus, ForgetsTheWordOfALauncherThatHasGone) {
  CommunityStatus status;
  status.Hear(Said("PLAUNCH_STATUS", kLaunched));
  EXPECT_THAT(status.Rows(), IsEmpty());
}

TEST(CommunityStatus, TellsWhatTheDatabaseLostAndRefused) {
  CommunityStatus status;
  status.Hear(Said("DB_DROPPED", ""));
  status.Hear(Said("DB_REFUSED", "type_mismatch=0,no_room=0"));
  EXPECT_THAT(status.Losses(), IsEmpty());
  status.Hear(Said("DB_DROPPED", "pSlow=12,"));
  status.Hear(Said("DB_REFUSED", "type_mismatch=3,foreign_source=0,no_room=10"));
  EXPECT_THAT(status.Losses(), ElementsAre("mail lost by slow readers: pSlow=12",
                                           "refused by the database: type_mismatch=3, no_room=10"));
}

TEST(CommunityStatus, BearsAnythingTheCommunitySays) {
  for (const char* text :
       {"", ",", "#", "=", ":SUBSCRIBED=", "PUBLISHED=", "a:SUBSCRIBED=PUBLISHED=", "app=,state=x",
        "app=a", "a=b=c:d,=:", "PUBLISHED=x:SUBSCRIBED="}) {
    CommunityStatus status;
    for (const char* name : {"PROC_SUMMARY", "DB_QOS", "PLAUNCH_STATUS", "X_STATUS"}) {
      status.Hear(Said(name, text));
    }
    EXPECT_LE(StatusTable(status.Rows()).size(), 2U) << text;
  }
}

TEST(StatusTable, LetsNoForeignByteReachTheTerminal) {
  EXPECT_EQ(PlainText(StatusTable({{.name = "p\033[2J", .is_present = true, .warnings = "a\nb"}})),
            "PROCESS   STATE  READS  WRITES  DELAY ms  RESTARTS  NOTE\n"
            "p\\x1b[2J  guest  0      0       -         -         a\\nb\n");
}

}  // namespace
}  // namespace limpet
