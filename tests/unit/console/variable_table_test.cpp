// SPDX-License-Identifier: MIT
#include "limpet/console/variable_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;

Message Write(const std::string& name, Value value, double time, const std::string& source = "pA") {
  return {.name = name,
          .value = std::move(value),
          .time = Seconds(time),
          .source = source,
          .source_aux = "",
          .community = "alpha",
          .id = 7};
}
Message Latched(const std::string& name, Value value, double time) {
  Message message = Write(name, std::move(value), time);
  message.id = -1;
  return message;
}

std::vector<std::string> NamesOf(const std::vector<const VariableRow*>& rows) {
  std::vector<std::string> names;
  for (const VariableRow* row : rows) {
    names.push_back(row->name);
  }
  return names;
}

TEST(RateEstimate, IsUnknownAfterOneEvent) {
  RateEstimate rate;
  rate.Note(Seconds(1));
  EXPECT_EQ(rate.At(Seconds(2)), 0.0);
}

TEST(RateEstimate, MeasuresARegularTrain) {
  RateEstimate rate;
  for (int i = 0; i <= 1000; ++i) {
    rate.Note(Seconds(100.0 + 0.02 * i));
  }
  EXPECT_NEAR(rate.At(Seconds(120.01)), 50.0, 0.1);
}

TEST(RateEstimate, DoesNotOvercountWhatComesInLumps) {
  RateEstimate rate;
  for (int lump = 0; lump < 20; ++lump) {
    for (int i = 0; i < 25; ++i) {
      rate.Note(Seconds(lump));
    }
  }
  EXPECT_NEAR(rate.At(Seconds(19.0)), 25.0, 1e-9);
}

TEST(RateEstimate, MeasuresWhatIsSlowerThanItsWindow) {
  RateEstimate rate;
  for (int i = 0; i < 5; ++i) {
    rate.Note(Seconds(60.0 * i));
  }
  EXPECT_NEAR(rate.At(Seconds(240.0)), 1.0 / 60.0, 1e-9);
}

TEST(RateEstimate, FollowsAChangeWithinItsWindow) {
  RateEstimate rate;
  for (int i = 0; i < 1000; ++i) {
    rate.Note(Seconds(0.01 * i));
  }
  for (int i = 0; i < 20; ++i) {
    rate.Note(Seconds(10.0 + i));
  }
  EXPECT_NEAR(rate.At(Seconds(29.0)), 1.0, 1e-9);
}

TEST(RateEstimate, FallsOnceAnEventIsOverdue) {
  RateEstimate rate;
  for (int i = 0; i <= 80; ++i) {
    rate.Note(Seconds(0.1 * i));
  }
  EXPECT_NEAR(rate.At(Seconds(8.0)), 10.0, 1e-6);
  EXPECT_LT(rate.At(Seconds(16.0)), 5.1);
  EXPECT_LT(rate.At(Seconds(800.0)), 0.11);
}

TEST(VariableTable, KnowsTheLastWriteAndWhoMadeIt) {
  VariableTable table;
  table.Hear(Write("X", 1.0, 100), Seconds(100));
  table.Hear(Write("X", 2.0, 101, "pB"), Seconds(101));
  const VariableRow& row = *table.Find("X");
  EXPECT_EQ(row.value.number, 2.0);
  EXPECT_EQ(row.source, "pB");
  EXPECT_EQ(row.writes, 2U);
  EXPECT_EQ(row.Age(Seconds(103)).value(), 2.0);
  EXPECT_NEAR(row.RateAt(Seconds(101)), 1.0, 1e-9);
}

TEST(VariableTable, TakesTheAgeOfWhatTheBrokerStillHadFromItsStamp) {
  VariableTable table;
  table.Hear(Latched("X", 1.0, 40), Seconds(100));
  EXPECT_EQ(table.Find("X")->Age(Seconds(100)).value(), 60.0);
  EXPECT_EQ(table.Find("X")->writes, 0U);
}

TEST(VariableTable, CountsTheBrokersOwnNewsThoughItHasNoId) {
  VariableTable table;
  for (int i = 0; i < 5; ++i) {
    table.Hear(Latched("DB_TIME", 2.0 * i, 2.0 * i), Seconds(2.0 * i));
  }
  EXPECT_EQ(table.Find("DB_TIME")->writes, 4U);
  EXPECT_NEAR(table.Find("DB_TIME")->RateAt(Seconds(8.0)), 0.5, 1e-9);
}

TEST(VariableTable, DoesNotCountARepetitionAfterReconnecting) {
  VariableTable table;
  table.Hear(Write("X", 1.0, 100), Seconds(100));
  table.Hear(Latched("X", 1.0, 100), Seconds(150));
  EXPECT_EQ(table.Find("X")->writes, 1U);
  EXPECT_EQ(table.Find("X")->Age(Seconds(150)).value(), 50.0);
  EXPECT_EQ(table.Find("X")->history.size(), 1U);
}

TEST(VariableTable, TrustsNoForeignClock) {
  VariableTable table;
  table.Hear(Write("X", 1.0, 1e9), Seconds(100));
  EXPECT_EQ(table.Find("X")->Age(Seconds(101)).value(), 1.0);
}

TEST(VariableTable, BoundsItsHistory) {
  VariableTable table;
  for (int i = 0; i < 2000; ++i) {
    table.Hear(Write("X", std::string(100'000, 'x'), i), Seconds(i));
  }
  const VariableRow& row = *table.Find("X");
  EXPECT_EQ(row.history.size(), VariableTable::kMostHistory);
  EXPECT_EQ(row.history.back().time.value(), 1999.0);
  EXPECT_LE(row.history.back().value.head.size(), VariableTable::kHistoryBytes);
  EXPECT_EQ(row.history.back().value.size, 100'000U);
}

TEST(VariableTable, SaysWhatHasStopped) {
  VariableTable table;
  for (int i = 0; i < 20; ++i) {
    table.Hear(Write("X", 1.0, i), Seconds(i));
  }
  EXPECT_FALSE(table.Find("X")->IsOverdue(Seconds(22)));
  EXPECT_TRUE(table.Find("X")->IsOverdue(Seconds(30)));
}

class ArrangedTest : public ::testing::Test {
 protected:
  ArrangedTest() {
    table_.Hear(Write("NAV_Y", 1.0, 10, "pNav"), Seconds(10));
    table_.Hear(Write("NAV_X", 1.0, 50, "pNav"), Seconds(50));
    table_.Hear(Write("DEPLOY", std::string("true"), 30, "pA"), Seconds(30));
    table_.Hear(Write("NAV_X", 2.0, 51, "pNav"), Seconds(51));
  }
  [[nodiscard]] std::vector<std::string> Names(const ScopeFilter& filter,
                                               ScopeSort sort = ScopeSort::kName,
                                               bool is_reversed = false) const {
    return NamesOf(Arranged(table_, filter, sort, is_reversed, Seconds(60)));
  }
  VariableTable table_;
};

TEST_F(ArrangedTest, SortsAsAsked) {
  EXPECT_THAT(Names({}), ElementsAre("DEPLOY", "NAV_X", "NAV_Y"));
  EXPECT_THAT(Names({}, ScopeSort::kName, true), ElementsAre("NAV_Y", "NAV_X", "DEPLOY"));
  EXPECT_THAT(Names({}, ScopeSort::kAge), ElementsAre("NAV_X", "DEPLOY", "NAV_Y"));
  EXPECT_THAT(Names({}, ScopeSort::kRate), ElementsAre("NAV_X", "DEPLOY", "NAV_Y"));
  EXPECT_THAT(Names({}, ScopeSort::kSource), ElementsAre("DEPLOY", "NAV_X", "NAV_Y"));
}

TEST_F(ArrangedTest, TakesPatternsAsMoosUsersTypeThem) {
  EXPECT_THAT(Names({.names = {"NAV_*"}}), ElementsAre("NAV_X", "NAV_Y"));
  EXPECT_THAT(Names({.names = {"*_X", "DEPLOY"}}), ElementsAre("DEPLOY", "NAV_X"));
  EXPECT_THAT(Names({.names = {"NAV"}}), ElementsAre());
  EXPECT_THAT(Names({.sources = {"pN*"}}), ElementsAre("NAV_X", "NAV_Y"));
}

TEST_F(ArrangedTest, FindsTypedWordsAnywhereInAName) {
  EXPECT_THAT(Names({.typed = "nav"}), ElementsAre("NAV_X", "NAV_Y"));
  EXPECT_THAT(Names({.typed = "_y plo"}), ElementsAre("DEPLOY", "NAV_Y"));
  EXPECT_THAT(Names({.typed = "*_x"}), ElementsAre("NAV_X"));
  EXPECT_THAT(Names({.typed = "  "}), ElementsAre("DEPLOY", "NAV_X", "NAV_Y"));
}

TEST_F(ArrangedTest, ShowsOnlyWhatHasChanged) {
  EXPECT_THAT(Names({.changed_only = true}), ElementsAre("NAV_X"));
}

TEST_F(ArrangedTest, KeepsTheOrderOfRatesThatHardlyDiffer) {
  VariableTable table;
  for (int i = 0; i < 100; ++i) {
    table.Hear(Write("B", 1.0, 0), Seconds(0.1000 * i));
    table.Hear(Write("A", 1.0, 0), Seconds(0.1002 * i));
  }
  EXPECT_THAT(NamesOf(Arranged(table, {}, ScopeSort::kRate, false, Seconds(10))),
              ElementsAre("A", "B"));
}

}  // namespace
}  // namespace limpet
