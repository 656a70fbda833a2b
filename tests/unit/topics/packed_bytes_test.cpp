// SPDX-License-Identifier: MIT
#include "limpet/topics/packed_bytes.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

using PackedCodec = TopicCodec<PackedBytes>;

TEST(PackedBytes, TravelSmallAndArriveWhole) {
  const PackedBytes map{std::string(100'000, 'm')};
  const Value sent = PackedCodec::Encode(map);
  EXPECT_LT(std::get<Binary>(sent).size(), 2'000U);
  EXPECT_EQ(PackedCodec::Decode(sent), map);
}

TEST(PackedBytes, OfOlderLogsArePlain) {
  EXPECT_EQ(PackedCodec::Decode(Binary{std::byte{'d'}, std::byte{'e'}}), PackedBytes{"de"});
  EXPECT_EQ(PackedCodec::Decode(Binary{}), PackedBytes{""});
}

TEST(PackedBytes, DamagedAreNone) {
  Binary sent = std::get<Binary>(PackedCodec::Encode(PackedBytes{"map"}));
  sent.resize(sent.size() - 3);
  EXPECT_EQ(PackedCodec::Decode(sent), std::nullopt);
  EXPECT_EQ(PackedCodec::Decode(std::string("text")), std::nullopt);
}

}  // namespace
}  // namespace limpet
