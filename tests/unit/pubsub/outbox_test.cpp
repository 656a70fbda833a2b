// SPDX-License-Identifier: MIT
#include "limpet/pubsub/outbox.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

ByteBuffer Mail(int value, std::size_t size) {
  return ByteBuffer(size, static_cast<std::byte>(value));
}

/// First byte of each message of `size` bytes.
std::vector<int> Values(Outbox& outbox, std::size_t size) {
  ByteBuffer body;
  static_cast<void>(outbox.Take(body));
  std::vector<int> values;
  for (std::size_t i = 0; i < body.size(); i += size) {
    values.push_back(std::to_integer<int>(body[i]));
  }
  return values;
}

TEST(Outbox, GivesMailInOrder) {
  Outbox outbox(1000);
  outbox.Append(1, Mail(1, 10));
  outbox.Append(2, Mail(2, 10));
  outbox.Append(1, Mail(3, 10));
  EXPECT_EQ(Values(outbox, 10), (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(outbox.empty());
}

TEST(Outbox, LosesTheOldestOfTheVariableThatHasNews) {
  Outbox outbox(80);
  outbox.Append(7, Mail(99, 10));
  for (int i = 0; i < 7; ++i) {
    outbox.Append(1, Mail(i, 10));
  }
  outbox.Append(1, Mail(7, 10));
  const std::vector<int> values = Values(outbox, 10);
  EXPECT_EQ(values.front(), 99) << "another variable's only value stays";
  EXPECT_EQ(values[1], 2) << "room for the news and an eighth";
  EXPECT_EQ(values.back(), 7);
  EXPECT_EQ(outbox.dropped(), 2U);
}

TEST(Outbox, LosesTheOldestOfAllWhenTheVariableHasNoneToLose) {
  Outbox outbox(80);
  for (int i = 0; i < 8; ++i) {
    outbox.Append(static_cast<Router::Variable>(i), Mail(i, 10));
  }
  outbox.Append(50, Mail(50, 10));
  const std::vector<int> values = Values(outbox, 10);
  EXPECT_EQ(values.front(), 2);
  EXPECT_EQ(values.back(), 50);
}

TEST(Outbox, NeverHoldsMoreThanItsLimit) {
  Outbox outbox(1000);
  outbox.SetInFlight(300);
  for (int i = 0; i < 10'000; ++i) {
    outbox.Append(static_cast<Router::Variable>(i % 5),
                  Mail(i & 127, 1 + static_cast<std::size_t>(i) % 90));
    EXPECT_LE(outbox.size() + 300, 1000U);
  }
  EXPECT_GT(outbox.dropped(), 9'000U);
}

TEST(Outbox, TakesAMessageLargerThanItselfAlone) {
  Outbox outbox(100);
  outbox.Append(1, Mail(1, 50));
  outbox.Append(1, Mail(2, 500));
  ByteBuffer body;
  EXPECT_EQ(outbox.Take(body), 1U);
  EXPECT_EQ(body.size(), 500U);
}

}  // namespace
}  // namespace limpet
