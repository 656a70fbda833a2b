// SPDX-License-Identifier: MIT
#include "limpet/durable/journal_format.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string JournalOf(const std::vector<std::string>& records) {
  std::string bytes(kJournalHeader);
  std::uint64_t chain = 0;
  for (const std::string& record : records) {
    AppendJournalRecord(bytes, chain, record);
  }
  return bytes;
}

std::vector<std::string> RecordsIn(const std::string& bytes) {
  std::istringstream in(bytes);
  JournalReader reader(in, bytes.size());
  std::vector<std::string> records;
  for (std::string payload; reader.Next(payload);) {
    records.push_back(payload);
  }
  return records;
}

TEST(JournalFormat, GivesBackTheRecordsInOrder) {
  EXPECT_THAT(RecordsIn(JournalOf({"one", "", "three"})), ElementsAre("one", "", "three"));
  EXPECT_THAT(RecordsIn(JournalOf({})), IsEmpty());
  EXPECT_THAT(RecordsIn(""), IsEmpty());
}

TEST(JournalFormat, EndsBeforeWhateverBitIsFlipped) {
  const std::string good = JournalOf({"one", "two", "three"});
  const std::size_t first_end = JournalOf({"one"}).size(),
                    second_end = JournalOf({"one", "two"}).size();
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
    const std::size_t sound = i < kJournalHeader.size() ? 0
                              : i < first_end           ? 0
                              : i < second_end          ? 1
                                                        : 2;
    EXPECT_EQ(RecordsIn(bad).size(), sound) << i;
  }
}

TEST(JournalFormat, TakesNoZerosForRecords) {
  EXPECT_THAT(RecordsIn(JournalOf({"one"}) + std::string(100, '\0')), ElementsAre("one"));
}

TEST(JournalFormat, TakesNothingOfAnEarlierLifeBehindItsEnd) {
  const std::string former = JournalOf({"same", "torn", "later"});
  std::string next = JournalOf({"same", "TORN"});
  next += former.substr(next.size());
  EXPECT_THAT(RecordsIn(next), ElementsAre("same", "TORN"));
}

}  // namespace
}  // namespace limpet
