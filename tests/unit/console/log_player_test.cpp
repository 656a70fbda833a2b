// SPDX-License-Identifier: MIT
#include "limpet/console/log_player.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

constexpr std::string_view kLog =
    "%% LOGSTART                  1767225600 \n"
    "-300.00000      SET                  pAuto           1.00000      \n"
    "0.50000         NAV_X                pNav            1.00000      \n"
    "0.60000         LABEL                pA              7 \n"
    "0.40000         LATE                 pNav            2.00000      \n"
    "1.50000         MODE                 pHelm:aux       ACTIVE \n"
    "1.60000         DB_TIME              MOOSDB_a        5 \n"
    "2.50000         LABEL                pA              seven \n";

class LogPlayerTest : public ::testing::Test {
 protected:
  void Open(PlayChoice choice, std::string_view text = kLog) {
    AlogReader first = AlogReader::OfText(text);
    LogOutline outline = LogOutline::Of(first, choice);
    player_.emplace(AlogReader::OfText(text), std::move(choice), std::move(outline),
                    folder_.path());
  }
  /// Names of what is due by then.
  std::vector<std::string> DueBy(double elapsed) {
    std::vector<std::string> names;
    while (const auto message = player_->Next(elapsed)) {
      names.push_back(message->name);
      last_ = *message;
    }
    return names;
  }
  TemporaryFolder folder_;
  std::optional<LogPlayer> player_;
  Message last_;
};

TEST_F(LogPlayerTest, KeepsTheLogsPausesAndItsOrder) {
  Open({});
  EXPECT_THAT(DueBy(0.0), ElementsAre("SET")) << "older than the log: due at once";
  EXPECT_DOUBLE_EQ(player_->next_due(), 0.5);
  EXPECT_THAT(DueBy(0.59), ElementsAre("NAV_X"));
  EXPECT_THAT(DueBy(0.6), ElementsAre("LABEL", "LATE")) << "logged late: not before its neighbour";
  EXPECT_THAT(DueBy(100.0), ElementsAre("MODE", "LABEL"));
  EXPECT_TRUE(player_->is_at_end());
  EXPECT_EQ(player_->played(), 6U);
}

TEST_F(LogPlayerTest, PlaysTheWholeLogAtOnceIfAsked) {
  Open({});
  EXPECT_EQ(DueBy(LogPlayer::kWholeLog).size(), 6U);
}

TEST_F(LogPlayerTest, KeepsWhoWroteWhat) {
  Open({.only = {"MODE"}});
  EXPECT_THAT(DueBy(LogPlayer::kWholeLog), ElementsAre("MODE"));
  EXPECT_EQ(last_.source, "pHelm");
  EXPECT_EQ(last_.source_aux, "aux");
  EXPECT_EQ(last_.value, Value(std::string("ACTIVE")));
}

TEST_F(LogPlayerTest, GivesAVariableOneTypeForTheWholeLog) {
  Open({.only = {"LABEL"}});
  const auto first = player_->Next(LogPlayer::kWholeLog);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->value, Value(std::string("7"))) << "it is a string later on";
}

TEST_F(LogPlayerTest, LeavesTheDatabasesOwnVariablesOutUnlessTheyAreNamed) {
  Open({.only = {"DB_*"}});
  EXPECT_THAT(DueBy(LogPlayer::kWholeLog), ElementsAre("DB_TIME"));
}

TEST_F(LogPlayerTest, ChoosesByPatternAndTime) {
  Open({.skip = {"L*"}, .from = 0.5, .to = 1.5, .begins_with_held = false});
  EXPECT_THAT(DueBy(0.0), ElementsAre("NAV_X")) << "time counts from --from";
  EXPECT_THAT(DueBy(1.0), ElementsAre("MODE"));
}

TEST_F(LogPlayerTest, BeginsWithWhatHeldThen) {
  Open({.from = 1.55});
  EXPECT_THAT(DueBy(0.0), ElementsAre("SET", "NAV_X", "LABEL", "LATE", "MODE"));
  EXPECT_EQ(last_.source_aux, "aux");
  EXPECT_THAT(DueBy(0.95), ElementsAre("LABEL"));
}

TEST_F(LogPlayerTest, BeginsWithTheLastValueOfEachVariable) {
  Open({.only = {"A"}, .from = 3.0}, "%% LOGSTART 5 \n1.0 A p 1 \n2.0 A p 2 \n4.0 A p 3 \n");
  EXPECT_THAT(DueBy(0.0), ElementsAre("A"));
  EXPECT_EQ(last_.value, Value(2.0));
}

TEST_F(LogPlayerTest, BeginsWithNothingElseIfAsked) {
  Open({.from = 1.55, .begins_with_held = false});
  EXPECT_THAT(DueBy(100.0), ElementsAre("LABEL"));
}

TEST_F(LogPlayerTest, BeginsAClippedLogAtOnce) {
  Open({}, "%% LOGSTART 5 \n120.00000 A p 1 \n121.00000 B p 2 \n");
  EXPECT_THAT(DueBy(0.0), ElementsAre("A"));
  EXPECT_THAT(DueBy(1.0), ElementsAre("B"));
  EXPECT_EQ(player_->outline().end, 121.0);
}

TEST_F(LogPlayerTest, TakesBinariesFromTheFileBesideTheLog) {
  std::ofstream(folder_.path() / "a.blog") << "abcdef";
  Open({},
       "%% LOGSTART 5 \n"
       "1.0 PIC p <MOOS_BINARY>File=a.blog,Offset=2,Bytes=3</MOOS_BINARY> \n"
       "2.0 PIC p <MOOS_BINARY>File=a.blog,Offset=5,Bytes=3</MOOS_BINARY> \n"
       "3.0 END p 1 \n");
  EXPECT_THAT(DueBy(0.0), ElementsAre("PIC"));
  EXPECT_EQ(last_.value, Value(Binary{std::byte{'c'}, std::byte{'d'}, std::byte{'e'}}));
  EXPECT_THAT(DueBy(2.0), ElementsAre("END"));
  EXPECT_EQ(player_->unreadable(), 1U);
}

TEST_F(LogPlayerTest, HasNothingToSayOfAnEmptyLog) {
  Open({}, "");
  EXPECT_TRUE(player_->is_at_end());
  EXPECT_EQ(player_->outline().entries, 0U);
}

}  // namespace
}  // namespace limpet
