// SPDX-License-Identifier: MIT
#include "limpet/wire/message_codec.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/wire/little_endian.hpp"
#include "limpet/wire/packet_codec.hpp"

namespace limpet {
namespace {

WireMessage Sample() {
  return {.id = 7,
          .type = wire_type::kNotify,
          .data_type = wire_data::kString,
          .source = "pNav",
          .source_aux = "aux",
          .community = "alpha",
          .key = "NAV_X",
          .time = 1.5,
          .number = -2.25,
          .number2 = -1.0,
          .text = "hi"};
}

ByteBuffer Encoded(const WireMessage& message) {
  ByteBuffer bytes;
  AppendMessage(message, bytes);
  return bytes;
}

void ExpectEqual(const WireMessage& a, const WireMessage& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.data_type, b.data_type);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.source_aux, b.source_aux);
  EXPECT_EQ(a.community, b.community);
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.number2, b.number2);
  EXPECT_EQ(a.text, b.text);
}

TEST(MessageCodec, ComesBackAsItWas) {
  const ByteBuffer bytes = Encoded(Sample());
  const auto decoded = DecodeMessage(bytes);
  ASSERT_TRUE(decoded.has_value());
  EXPECT_EQ(decoded->size, bytes.size());
  ExpectEqual(decoded->message, Sample());
}

TEST(MessageCodec, HasTheBytesOfTheProtocol) {
  // Worked out by hand from the field table in docs/wire.md.
  const ByteBuffer bytes =
      Encoded({.id = 1, .source = "a", .key = "X", .time = 0.0, .number = 1.0});
  ASSERT_EQ(bytes.size(), 56U);
  const auto at = [&bytes](std::size_t i) { return std::to_integer<int>(bytes[i]); };
  EXPECT_EQ(at(0), 56);   // length
  EXPECT_EQ(at(4), 1);    // id
  EXPECT_EQ(at(8), 'N');  // message type
  EXPECT_EQ(at(9), 'D');  // data type
  EXPECT_EQ(at(10), 1);   // bytes of source
  EXPECT_EQ(at(14), 'a');
  EXPECT_EQ(at(15), 0);  // bytes of source aux
  EXPECT_EQ(at(19), 0);  // bytes of community
  EXPECT_EQ(at(23), 1);  // bytes of key
  EXPECT_EQ(at(27), 'X');
  EXPECT_EQ(at(42), 0xF0);  // 1.0 is 3F F0 00 ...
  EXPECT_EQ(at(43), 0x3F);
  EXPECT_EQ(at(51), 0xBF);  // -1.0 is BF F0 00 ...
  EXPECT_EQ(at(52), 0);     // bytes of string
}

TEST(MessageCodec, KeepsAnyBytesOfABinary) {
  std::string all(256, '\0');
  for (int i = 0; i < 256; ++i) {
    all[static_cast<std::size_t>(i)] = static_cast<char>(i);
  }
  WireMessage message = Sample();
  message.text = all;
  const ByteBuffer bytes = Encoded(message);
  EXPECT_EQ(DecodeMessage(bytes)->message.text, all);
}

TEST(MessageCodec, RefusesEveryTruncation) {
  const ByteBuffer bytes = Encoded(Sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(DecodeMessage(ByteView(bytes).first(size)).has_value()) << size;
  }
}

TEST(MessageCodec, RefusesStringsThatDoNotFit) {
  for (const std::int32_t length : {-1, 2, 1'000'000, std::numeric_limits<std::int32_t>::max()}) {
    ByteBuffer bytes = Encoded(Sample());
    Put(bytes.data() + 10, length);  // of the source, which has 4
    EXPECT_FALSE(DecodeMessage(bytes).has_value()) << length;
  }
}

TEST(MessageCodec, SurvivesAnyMutation) {
  Random random(5, "mutation");
  for (int round = 0; round < 20'000; ++round) {
    ByteBuffer bytes = Encoded(Sample());
    for (int k = 0; k < 3; ++k) {
      bytes[static_cast<std::size_t>(random.Uniform(0.0, static_cast<double>(bytes.size())))] =
          static_cast<std::byte>(random.Uniform(0.0, 256.0));
    }
    const auto decoded = DecodeMessage(bytes);
    if (decoded) {
      EXPECT_LE(decoded->size, bytes.size());
      EXPECT_EQ(EncodedSize(decoded->message), decoded->size);
    }
  }
}

TEST(PacketCodec, RefusesHeadersThatCannotBeTrue) {
  const auto header = [](std::int32_t size, std::int32_t count) {
    ByteBuffer bytes(kPacketHeaderSize);
    Put(Put(bytes.data(), size), count);
    return DecodePacketHeader(bytes).has_value();
  };
  EXPECT_TRUE(header(63, 1));
  EXPECT_FALSE(header(-1, 1));
  EXPECT_FALSE(header(0, 0));
  EXPECT_FALSE(header(8, 0));
  EXPECT_FALSE(header(0x7fffffff, 1));
  EXPECT_FALSE(header(69, 1'000'000));
  EXPECT_FALSE(header(63, -1));
}

TEST(PacketCodec, WalksItsMessagesAndStops) {
  ByteBuffer packet(kPacketHeaderSize);
  AppendMessage(Sample(), packet);
  AppendMessage(Sample(), packet);
  EncodePacketHeader({packet.size(), 2}, packet.data());
  PacketReader reader(packet);
  int count = 0;
  for (; !reader.is_at_end(); ++count) {
    ASSERT_TRUE(reader.Next().has_value());
  }
  EXPECT_EQ(count, 2);
}

TEST(PacketCodec, NoticesBytesAfterTheLastMessage) {
  ByteBuffer packet = PacketOf(Sample());
  packet.push_back(std::byte{0});
  EncodePacketHeader({packet.size(), 1}, packet.data());
  PacketReader reader(packet);
  ASSERT_TRUE(reader.Next().has_value());
  ASSERT_FALSE(reader.is_at_end());
  EXPECT_FALSE(reader.Next().has_value());
  EXPECT_TRUE(reader.is_at_end());
}

TEST(PacketCodec, KnowsTheGreetingInAnyCase) {
  ByteBuffer bytes(kGreeting.size());
  std::memcpy(bytes.data(), kGreeting.data(), kGreeting.size());
  EXPECT_TRUE(IsGreeting(bytes));
  bytes[0] = std::byte{'e'};
  EXPECT_TRUE(IsGreeting(bytes));
  bytes[0] = std::byte{'x'};
  EXPECT_FALSE(IsGreeting(bytes));
}

}  // namespace
}  // namespace limpet
