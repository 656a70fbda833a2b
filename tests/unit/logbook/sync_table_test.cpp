// SPDX-License-Identifier: MIT
#include "limpet/logbook/sync_table.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace limpet {
namespace {

Message Mail(const std::string& name, const Value& value) {
  Message message;
  message.name = name;
  message.value = value;
  return message;
}
Message Number(const std::string& name, double value) { return Mail(name, value); }

TEST(SyncTable, HasTheLastNumberOfEachColumnOncePerPeriod) {
  SyncTable table({"A", "B"}, Seconds(0.2));
  table.Update(Number("A", 1.0));
  table.Update(Number("A", 2.0));
  table.Update(Number("OTHER", 9.0));
  EXPECT_FALSE(table.TakeDueRow(Seconds(0.19)));
  const auto row = table.TakeDueRow(Seconds(0.21));
  ASSERT_TRUE(row);
  EXPECT_DOUBLE_EQ(row->time, 0.2);
  EXPECT_EQ(row->values[0], 2.0);
  EXPECT_TRUE(std::isnan(row->values[1])) << "none came";
  EXPECT_FALSE(table.TakeDueRow(Seconds(0.3)));
}

TEST(SyncTable, ANumberIsFreshOnce) {
  SyncTable table({"A"}, Seconds(1.0));
  table.Update(Number("A", 1.0));
  ASSERT_TRUE(table.TakeDueRow(Seconds(1.0)));
  const auto next = table.TakeDueRow(Seconds(2.0));
  ASSERT_TRUE(next);
  EXPECT_TRUE(std::isnan(next->values[0]));
}

TEST(SyncTable, SkipsRowsOfATimeThatNobodyAskedAbout) {
  SyncTable table({"A"}, Seconds(1.0));
  table.Update(Number("A", 1.0));
  const auto row = table.TakeDueRow(Seconds(7.9));
  ASSERT_TRUE(row);
  EXPECT_EQ(row->time, 7.0);
  EXPECT_FALSE(table.TakeDueRow(Seconds(7.95)));
  EXPECT_FALSE(table.TakeDueRow(Seconds(1e30))) << "no place on any grid";
}

TEST(SyncTable, ANewColumnComesLastAndTextIsNoNumber) {
  SyncTable table({"A"}, Seconds(1.0));
  table.AddColumn("B");
  table.Update(Number("B", 3.0));
  table.Update(Mail("A", std::string("3")));
  const auto row = table.TakeDueRow(Seconds(1.0));
  ASSERT_TRUE(row);
  ASSERT_EQ(row->values.size(), 2U);
  EXPECT_TRUE(std::isnan(row->values[0]));
  EXPECT_EQ(row->values[1], 3.0);
}

TEST(SyncTable, APeriodIsReadBehindItsSwitch) {
  EXPECT_EQ(*ParseSyncLog("true"), Seconds(1.0));
  EXPECT_EQ(*ParseSyncLog("true @ 0.25"), Seconds(0.25));
  EXPECT_EQ(*ParseSyncLog("true @ 0.01"), Seconds(0.1)) << "no faster";
  EXPECT_EQ(*ParseSyncLog("false @ 2"), std::nullopt);
  for (const char* wrong : {"", "perhaps", "true @", "true @ x", "true @ -1"})
    EXPECT_FALSE(ParseSyncLog(wrong)) << wrong;
}

}  // namespace
}  // namespace limpet
