// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/topics/chips.hpp"

namespace limpet {
namespace {

ImageChips RandomChips(Random& random) {
  ImageChips chips{.exposure = Seconds(random.Uniform(0.0, 1e9)), .chips = {}};
  const std::size_t count = random.Index(5);
  for (std::size_t i = 0; i < count; ++i) {
    ImageChip chip{.box = {.u = 0.5 * static_cast<double>(random.Index(1280)),
                           .v = 0.25 * static_cast<double>(random.Index(900)),
                           .w = 12.5,
                           .h = 30.0,
                           .confidence = 0.75,
                           .color = std::string(random.Index(9), 'y')},
                   .jpeg = {}};
    for (std::size_t n = random.Index(200); n > 0; --n)
      chip.jpeg += static_cast<char>(random.Index(256));
    chips.chips.push_back(chip);
  }
  return chips;
}

TEST(ImageChips, ComeBackFromTheirBytes) {
  Random random(7, "chips");
  for (int round = 0; round < 100; ++round) {
    const ImageChips sent = RandomChips(random);
    const auto back = TopicCodec<ImageChips>::Decode(TopicCodec<ImageChips>::Encode(sent));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->exposure.value(), sent.exposure.value());
    ASSERT_EQ(back->chips.size(), sent.chips.size());
    for (std::size_t i = 0; i < sent.chips.size(); ++i) {
      EXPECT_EQ(back->chips[i].jpeg, sent.chips[i].jpeg);
      EXPECT_EQ(back->chips[i].box.color, sent.chips[i].box.color);
      EXPECT_EQ(back->chips[i].box.u, sent.chips[i].box.u);
      EXPECT_EQ(back->chips[i].box.confidence, sent.chips[i].box.confidence);
    }
  }
}

TEST(ImageChips, AreRefusedWhereTheyEndTooEarlyOrTooLate) {
  Random random(8, "chips");
  ImageChips sent = RandomChips(random);
  sent.chips.push_back({.box = {.color = "red"}, .jpeg = "picture"});
  Binary bytes = std::get<Binary>(TopicCodec<ImageChips>::Encode(sent));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(TopicCodec<ImageChips>::Decode(
        Binary(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))))
        << size;
  }
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(TopicCodec<ImageChips>::Decode(bytes));
}

TEST(ImageChips, AreRefusedWithAPlaceThatIsNoNumber) {
  ImageChips sent{.exposure = Seconds(1.0), .chips = {{.box = {}, .jpeg = "x"}}};
  sent.chips.front().box.w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(TopicCodec<ImageChips>::Decode(TopicCodec<ImageChips>::Encode(sent)));
}

TEST(ImageChips, AreNoText) {
  EXPECT_FALSE(TopicCodec<ImageChips>::Decode(Value(std::string("LIC1"))));
}

}  // namespace
}  // namespace limpet
