// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_datagram.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/wire/little_endian.hpp"
#include "limpet/wire/message_codec.hpp"
#include "tests/support/moos_captures.hpp"

namespace limpet {
namespace {

constexpr WireMessage kDepth{.id = 2,
                             .source = "pSrc",
                             .community = "alpha",
                             .key = "Y",
                             .time = 1795246022.5,
                             .number = 7.5};

/// What MOOS's pShare sends for kDepth, byte for byte: a bare message, no header.
constexpr unsigned char kDepthBytes[] = {
    64, 0, 0,    0,    2,    0,    0,    0,    'N', 'D',                // size, id, types
    4,  0, 0,    0,    'p',  'S',  'r',  'c',  0,   0,   0, 0,          // source, aux
    5,  0, 0,    0,    'a',  'l',  'p',  'h',  'a', 1,   0, 0, 0, 'Y',  // community, name
    0,  0, 0xa0, 0xf1, 0x51, 0xc0, 0xda, 0x41,                          // time
    0,  0, 0,    0,    0,    0,    0x1e, 0x40, 0,   0,   0, 0, 0, 0,   0xf0, 0xbf,  // 7.5, -1
    0,  0, 0,    0};                                                                // text

ByteView Bytes(const unsigned char* data, std::size_t size) {
  return {reinterpret_cast<const std::byte*>(data), size};
}

ByteBuffer Encoded(const WireMessage& message) {
  ByteBuffer bytes;
  AppendMessage(message, bytes);
  return bytes;
}

bool IsRefused(ByteView datagram) { return !DecodeShare(datagram).has_value(); }

TEST(ShareDatagram, IsABareMessage) {
  const auto bytes = EncodeShare(kDepth);
  ASSERT_TRUE(bytes.has_value());
  EXPECT_TRUE(std::ranges::equal(*bytes, Bytes(kDepthBytes, sizeof kDepthBytes)));
}

TEST(ShareDatagram, ReadsWhatAStockPShareSends) {
  const auto message = DecodeShare(Bytes(kDepthBytes, sizeof kDepthBytes));
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->key, "Y");
  EXPECT_EQ(message->source, "pSrc");
  EXPECT_EQ(message->community, "alpha");
  EXPECT_EQ(message->time, 1795246022.5);
  EXPECT_EQ(message->number, 7.5);
}

TEST(ShareDatagram, RecordedOnesComeBackByteForByte) {
  const auto files = Captures(".datagram.bin");
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    const ByteBuffer bytes = BytesOfFile(file);
    const auto message = DecodeShare(bytes);
    ASSERT_TRUE(message.has_value()) << file << ": " << message.error().text;
    EXPECT_EQ(*EncodeShare(*message), bytes) << file;
  }
}

TEST(ShareDatagram, RefusesWhatIsTooLargeToSend) {
  const std::string text(kLargestShare, 'x');
  EXPECT_FALSE(EncodeShare({.data_type = wire_data::kString, .key = "X", .text = text}));
}

TEST(ShareDatagram, RefusesEveryCutOne) {
  for (std::size_t size = 0; size < sizeof kDepthBytes; ++size) {
    EXPECT_TRUE(IsRefused(Bytes(kDepthBytes, size))) << size;
  }
}

TEST(ShareDatagram, RefusesBytesBehindTheMessage) {
  ByteBuffer bytes = Encoded(kDepth);
  bytes.push_back(std::byte{0});
  EXPECT_TRUE(IsRefused(bytes));
}

TEST(ShareDatagram, RefusesLengthsThatCannotBe) {
  constexpr std::size_t kLengths[] = {0, 10, 18, 22, 31};  // of the message and of its strings
  for (const std::size_t at : kLengths) {
    for (const std::int32_t length : {-1, INT32_MIN, INT32_MAX, 1 << 20}) {
      ByteBuffer bytes = Encoded(kDepth);
      Put(bytes.data() + at, length);
      EXPECT_TRUE(IsRefused(bytes)) << at << " " << length;
    }
  }
}

TEST(ShareDatagram, RefusesWhatIsNoWriteOfAVariable) {
  const auto is_refused = [](auto change) {
    WireMessage message = kDepth;
    change(message);
    return IsRefused(Encoded(message));
  };
  const std::string long_name(2000, 'X');
  EXPECT_TRUE(is_refused([](WireMessage& m) { m.type = wire_type::kRegister; }));
  EXPECT_TRUE(is_refused([](WireMessage& m) { m.data_type = wire_data::kUnset; }));
  EXPECT_TRUE(is_refused([](WireMessage& m) { m.key = ""; }));
  EXPECT_TRUE(is_refused([](WireMessage& m) { m.key = "A,B"; }));
  EXPECT_TRUE(is_refused([](WireMessage& m) { m.key = "A\nB"; }));
  EXPECT_TRUE(is_refused([&](WireMessage& m) { m.key = long_name; }));
  EXPECT_TRUE(is_refused([&](WireMessage& m) { m.source = long_name; }));
  EXPECT_TRUE(
      is_refused([](WireMessage& m) { m.time = std::numeric_limits<double>::quiet_NaN(); }));
}

TEST(ShareDatagram, SurvivesNoise) {
  Random random(7, "noise");
  for (int i = 0; i < 20'000; ++i) {
    ByteBuffer bytes = Encoded(kDepth);
    const int changes = 1 + i % 4;
    for (int k = 0; k < changes; ++k) {
      const auto at =
          static_cast<std::size_t>(random.Uniform(0.0, static_cast<double>(bytes.size()) - 0.01));
      bytes[at] = static_cast<std::byte>(static_cast<int>(random.Uniform(0.0, 255.99)));
    }
    if (const auto message = DecodeShare(bytes)) {
      EXPECT_EQ(*EncodeShare(*message), bytes);
    }
  }
}

}  // namespace
}  // namespace limpet
