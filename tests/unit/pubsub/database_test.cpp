// SPDX-License-Identifier: MIT
// The semantics of MOOS's database: sections 4 and 5 of the wire protocol's description.
#include "limpet/pubsub/database.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class DatabaseTest : public ::testing::Test {
 protected:
  Database::WriteResult Write(const std::string& name, Value value,
                              const std::string& source = "pA", double time = 0.0) {
    return database_.Write({.name = name,
                            .value = std::move(value),
                            .time = Seconds(time),
                            .source = source,
                            .source_aux = "aux",
                            .community = "",
                            .id = 7},
                           Seconds(time));
  }
  std::vector<std::string> NamesFor(Database::Client client) {
    std::vector<std::string> names;
    for (const MessagePtr& message : database_.TakeMail(client)) {
      names.push_back(message->name);
    }
    return names;
  }

  Database database_{"alpha"};
  Database::Client reader_ = *database_.Connect("pReader");
};

TEST_F(DatabaseTest, DeliversEveryWriteToASubscriber) {
  database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(0.0));
  Write("X", 1.0);
  Write("Y", 2.0);
  Write("X", 3.0);
  const auto mail = database_.TakeMail(reader_);
  ASSERT_EQ(mail.size(), 2U);
  EXPECT_EQ(mail[1]->value, Value(3.0));
  EXPECT_EQ(mail[1]->id, 7);
  EXPECT_THAT(database_.TakeMail(reader_), IsEmpty());
}

TEST_F(DatabaseTest, FillsInItsCommunity) {
  Write("X", 1.0);
  EXPECT_EQ(database_.Latest("X")->community, "alpha");
}

TEST_F(DatabaseTest, LatchesTheCurrentValueOnEverySubscription) {
  Write("X", 1.0, "pA", 5.0);
  for (int i = 0; i < 2; ++i) {
    database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(6.0));
    const auto mail = database_.TakeMail(reader_);
    ASSERT_EQ(mail.size(), 1U);
    EXPECT_EQ(mail[0]->time, Seconds(5.0));
    EXPECT_EQ(mail[0]->source_aux, "aux");
    EXPECT_EQ(mail[0]->id, -1);
  }
}

TEST_F(DatabaseTest, SendsNothingForAVariableNeverWritten) {
  database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(0.0));
  EXPECT_FALSE(database_.HasMail(reader_));
  EXPECT_THAT(database_.Variables(), ElementsAre("X"));
  EXPECT_EQ(database_.Latest("X"), nullptr);
}

TEST_F(DatabaseTest, DropsWritesThatComeTooSoon) {
  database_.Subscribe(reader_, "X", Seconds(0.25), Seconds(0.0));
  for (int i = 0; i <= 20; ++i) {
    Write("X", static_cast<double>(i), "pA", 0.05 * i);
  }
  EXPECT_EQ(database_.TakeMail(reader_).size(), 5U);  // 0, 0.25, 0.5, 0.75, 1.0
}

TEST_F(DatabaseTest, TreatsANegativeIntervalAsNoneAndNanAsNever) {
  database_.Subscribe(reader_, "X", Seconds(-1.0), Seconds(0.0));
  database_.Subscribe(reader_, "Y", Seconds(std::numeric_limits<double>::quiet_NaN()),
                      Seconds(0.0));
  for (int i = 0; i < 3; ++i) {
    Write("X", 1.0);
    Write("Y", 1.0);
  }
  EXPECT_THAT(NamesFor(reader_), ElementsAre("X", "X", "X"));
}

TEST_F(DatabaseTest, ReplacesTheIntervalOfASecondSubscription) {
  database_.Subscribe(reader_, "X", Seconds(100.0), Seconds(0.0));
  database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(0.0));
  Write("X", 1.0);
  Write("X", 2.0);
  EXPECT_EQ(database_.TakeMail(reader_).size(), 2U);
}

TEST_F(DatabaseTest, StopsAfterUnsubscription) {
  database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(0.0));
  database_.Unsubscribe(reader_, "X");
  Write("X", 1.0);
  EXPECT_FALSE(database_.HasMail(reader_));
}

TEST_F(DatabaseTest, FixesTheTypeAtTheFirstWrite) {
  database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(0.0));
  EXPECT_EQ(Write("X", 1.0), Database::WriteResult::kStored);
  EXPECT_EQ(Write("X", std::string("1")), Database::WriteResult::kTypeMismatch);
  EXPECT_EQ(Write("X", Binary{}), Database::WriteResult::kTypeMismatch);
  EXPECT_EQ(database_.Latest("X")->value, Value(1.0));
  EXPECT_EQ(database_.TakeMail(reader_).size(), 1U);
}

TEST_F(DatabaseTest, ReturnsItsOwnWritesToASubscriber) {
  database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(0.0));
  Write("X", 1.0, "pReader");
  EXPECT_TRUE(database_.HasMail(reader_));
}

TEST_F(DatabaseTest, SubscribesAWildcardToWhatExistsAndToWhatComes) {
  Write("NAV_X", 1.0);
  Write("MODE", std::string("A"));
  database_.SubscribeWildcard(
      reader_, {.app_pattern = "*", .variable_pattern = "NAV_?", .interval = {}}, Seconds(0.0));
  EXPECT_THAT(NamesFor(reader_), ElementsAre("NAV_X"));
  Write("NAV_Y", 1.0);
  Write("NAV_YAW", 1.0);
  EXPECT_THAT(NamesFor(reader_), ElementsAre("NAV_Y"));
}

TEST_F(DatabaseTest, JudgesAWildcardByTheLastWriterNowAndTheFirstLater) {
  Write("A", 1.0, "pOne");
  Write("A", 1.0, "pTwo");
  Write("B", 1.0, "pTwo");
  database_.SubscribeWildcard(
      reader_, {.app_pattern = "pOne", .variable_pattern = "*", .interval = {}}, Seconds(0.0));
  EXPECT_FALSE(database_.HasMail(reader_)) << "A was last written by pTwo";
  Write("C", 1.0, "pOne");
  Write("C", 1.0, "pTwo");
  EXPECT_THAT(NamesFor(reader_), ElementsAre("C", "C")) << "once subscribed, all writers count";
  Write("D", 1.0, "pTwo");
  Write("D", 1.0, "pOne");
  EXPECT_FALSE(database_.HasMail(reader_)) << "D was first written by pTwo";
}

TEST_F(DatabaseTest, LetsTheFirstOfTwoEqualFiltersWin) {
  database_.SubscribeWildcard(
      reader_, {.app_pattern = "*", .variable_pattern = "*", .interval = Seconds(0.0)},
      Seconds(0.0));
  database_.SubscribeWildcard(
      reader_, {.app_pattern = "*", .variable_pattern = "*", .interval = Seconds(100.0)},
      Seconds(0.0));
  Write("X", 1.0);
  Write("X", 2.0);
  EXPECT_EQ(database_.TakeMail(reader_).size(), 2U);
}

TEST_F(DatabaseTest, DropsTheFilterWithTheWildcard) {
  const WildcardFilter filter{.app_pattern = "*", .variable_pattern = "NAV_*", .interval = {}};
  Write("NAV_X", 1.0);
  database_.SubscribeWildcard(reader_, filter, Seconds(0.0));
  static_cast<void>(database_.TakeMail(reader_));
  database_.UnsubscribeWildcard(reader_, filter);
  Write("NAV_X", 2.0);
  Write("NAV_Y", 1.0);
  EXPECT_FALSE(database_.HasMail(reader_));
}

TEST_F(DatabaseTest, RefusesANameInUse) {
  EXPECT_FALSE(database_.Connect("pReader").has_value());
  EXPECT_FALSE(database_.Connect("").has_value());
  EXPECT_TRUE(database_.Connect("preader").has_value()) << "names compare with case";
}

TEST_F(DatabaseTest, ForgetsAClientThatLeavesButKeepsItsVariables) {
  database_.Subscribe(reader_, "X", Seconds(0.0), Seconds(0.0));
  database_.SubscribeWildcard(reader_, {}, Seconds(0.0));
  Write("X", 1.0, "pReader");
  database_.Disconnect(reader_);
  Write("X", 2.0);
  EXPECT_THAT(database_.Clients(), IsEmpty());
  EXPECT_EQ(database_.Latest("X")->value, Value(2.0));
  const auto again = database_.Connect("pReader");
  ASSERT_TRUE(again.has_value());
  EXPECT_FALSE(database_.HasMail(*again));
}

TEST(MatchesWildcard, FollowsStarsAndQuestionMarks) {
  EXPECT_TRUE(MatchesWildcard("*", ""));
  EXPECT_TRUE(MatchesWildcard("NAV_*", "NAV_"));
  EXPECT_TRUE(MatchesWildcard("*_X*", "NAV_X_Y"));
  EXPECT_TRUE(MatchesWildcard("a*b*c", "aXbYbZc"));
  EXPECT_TRUE(MatchesWildcard("?AV", "NAV"));
  EXPECT_FALSE(MatchesWildcard("?AV", "AV"));
  EXPECT_FALSE(MatchesWildcard("nav_*", "NAV_X"));
  EXPECT_FALSE(MatchesWildcard("NAV", "NAV_X"));
  EXPECT_FALSE(MatchesWildcard("", "X"));
}

}  // namespace
}  // namespace limpet
