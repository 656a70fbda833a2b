// SPDX-License-Identifier: MIT
#include "limpet/pubsub/outbox.hpp"

#include <array>

#include <gtest/gtest.h>

#include "tests/support/outgoing_bytes.hpp"

namespace limpet {
namespace {

ByteBuffer Mail(int value, std::size_t size) {
  return ByteBuffer(size, static_cast<std::byte>(value));
}

/// First byte of each message of `size` bytes.
std::vector<int> Values(Outbox& outbox, std::size_t size) {
  Parcel parcel;
  static_cast<void>(outbox.Take(parcel));
  const ByteBuffer body = BytesOf(parcel);
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
  Parcel parcel;
  EXPECT_EQ(outbox.Take(parcel), 1U);
  EXPECT_EQ(BytesOf(parcel), Mail(2, 500));
}

TEST(Outbox, LosesSharedAndCopiedMailAlike) {
  Outbox outbox(100'000);
  for (int i = 0; i < 40; ++i) {
    const std::size_t size = i % 2 == 0 ? 10 : kShareFrom;
    outbox.Append(1, Mail(i, size));
  }
  Parcel parcel;
  const std::size_t count = outbox.Take(parcel);
  EXPECT_EQ(count + outbox.dropped(), 40U);
  ByteBuffer expected;
  for (int i = 40 - static_cast<int>(count); i < 40; ++i) {
    const ByteBuffer mail = Mail(i, i % 2 == 0 ? 10 : kShareFrom);
    expected.insert(expected.end(), mail.begin(), mail.end());
  }
  EXPECT_EQ(BytesOf(parcel), expected);
}

TEST(Parcel, GathersFromAnyByteOnWhateverThePieces) {
  Parcel parcel;
  ByteBuffer expected;
  for (int i = 0; i < 6; ++i) {
    const ByteBuffer mail = Mail(i, i % 3 == 0 ? kShareFrom + 5 : 7);
    parcel.Append(std::make_shared<const ByteBuffer>(mail));
    expected.insert(expected.end(), mail.begin(), mail.end());
  }
  ASSERT_EQ(parcel.size(), expected.size());
  for (std::size_t at = 0; at < expected.size(); at += 3) {
    std::array<ByteView, 2> pieces;
    const std::size_t count = parcel.Gather(at, pieces);
    std::size_t end = at;
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(std::ranges::equal(pieces[i], ByteView(expected).subspan(end, pieces[i].size())));
      end += pieces[i].size();
    }
    ASSERT_GT(end, at);
  }
  std::array<ByteView, 2> pieces;
  EXPECT_EQ(parcel.Gather(parcel.size(), pieces), 0U);
}

TEST(Parcel, SharesLargeMailAndCopiesSmall) {
  const auto large = std::make_shared<const ByteBuffer>(Mail(1, kShareFrom));
  const auto small = std::make_shared<const ByteBuffer>(Mail(2, 10));
  Parcel parcel;
  parcel.Append(large);
  parcel.Append(small);
  EXPECT_EQ(large.use_count(), 2);
  EXPECT_EQ(small.use_count(), 1);
  parcel.Clear();
  EXPECT_EQ(large.use_count(), 1);
}

TEST(Parcel, LetsGoOfWhatIsSentAndGathersTheRest) {
  const auto first = std::make_shared<const ByteBuffer>(Mail(1, kShareFrom));
  const auto second = std::make_shared<const ByteBuffer>(Mail(2, kShareFrom));
  Parcel parcel;
  parcel.Append(first);
  parcel.Append(Mail(3, 10));
  parcel.Append(second);
  parcel.LetGo(kShareFrom + 10 + 1);
  EXPECT_EQ(first.use_count(), 1);
  EXPECT_EQ(second.use_count(), 2) << "part of it is still to be sent";
  std::array<ByteView, 4> pieces;
  ASSERT_EQ(parcel.Gather(kShareFrom + 10 + 1, pieces), 1U);
  EXPECT_TRUE(std::ranges::equal(pieces[0], ByteView(*second).subspan(1)));
}

TEST(Parcel, KeepsTheOrderOfManySmallMessages) {
  Parcel parcel;
  ByteBuffer expected;
  for (int i = 0; i < 5000; ++i) {
    const ByteBuffer mail = Mail(i & 127, 1 + static_cast<std::size_t>(i) % 100);
    parcel.Append(mail);
    expected.insert(expected.end(), mail.begin(), mail.end());
  }
  EXPECT_EQ(BytesOf(parcel), expected);
}

}  // namespace
}  // namespace limpet
