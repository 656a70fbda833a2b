// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/sharing/share_datagram.hpp"

namespace limpet {
namespace {

/// A message whose texts lie in `texts`.
WireMessage DrawMessage(Random& random, std::vector<std::string>& texts) {
  const auto draw = [&random](std::uint64_t longest) {
    std::string text;
    for (std::uint64_t i = random.Index(longest) + 1; i > 0; --i)
      text += static_cast<char>('A' + random.Index(26));
    return text;
  };
  texts = {draw(30), draw(30), draw(30), draw(2000), draw(20)};
  const bool is_text = random.Chance(0.5);
  return {.id = static_cast<std::int32_t>(random.Index(1000)),
          .data_type = is_text ? wire_data::kString : wire_data::kDouble,
          .source = texts[0],
          .source_aux = texts[4],
          .community = texts[1],
          .key = texts[2],
          .time = random.Uniform(0.0, 2e9),
          .number = is_text ? -1.0 : random.Normal(1e6),
          .text = is_text ? std::string_view(texts[3]) : std::string_view()};
}

TEST(ShareProperties, EveryMessageComesBackWhole) {
  Random random(111);
  std::vector<std::string> texts;
  for (int i = 0; i < 300; ++i) {
    const WireMessage sent = DrawMessage(random, texts);
    const auto bytes = EncodeShare(sent);
    ASSERT_TRUE(bytes);
    const auto back = DecodeShare(*bytes);
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(back->key, sent.key);
    EXPECT_EQ(back->source, sent.source);
    EXPECT_EQ(back->source_aux, sent.source_aux);
    EXPECT_EQ(back->community, sent.community);
    EXPECT_EQ(back->text, sent.text);
    EXPECT_EQ(back->time, sent.time);
    EXPECT_EQ(back->number, sent.number);
  }
}

TEST(ShareProperties, TheLargestMessageIsSentWholeAndOneByteMoreIsRefusedWithAReason) {
  const auto encode = [](std::size_t size) {
    const std::string text(size, 'x');
    return EncodeShare({.data_type = wire_data::kString, .key = "X", .text = text});
  };
  std::size_t fits = 1, too_large = kLargestShare + 1;
  ASSERT_TRUE(encode(fits));
  while (too_large - fits > 1) {
    const std::size_t middle = (fits + too_large) / 2;
    (encode(middle) ? fits : too_large) = middle;
  }
  EXPECT_EQ(encode(fits)->size(), kLargestShare);
  EXPECT_FALSE(encode(too_large).error().text.empty());
  EXPECT_TRUE(DecodeShare(*encode(fits)));
}

}  // namespace
}  // namespace limpet
