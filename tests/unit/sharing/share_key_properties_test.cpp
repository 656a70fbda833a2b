// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/sharing/share_key.hpp"

namespace limpet {
namespace {

TEST(ShareKeyProperties, EveryKeyComesBackFromItsTextAndNoDigitOfItMayBeWrong) {
  Random random(112);
  for (int i = 0; i < 40; ++i) {
    ShareKey::Bytes bytes{};
    for (unsigned char& byte : bytes)
      byte = static_cast<unsigned char>(random.Index(256));
    const ShareKey key(bytes);
    const auto back = ShareKey::Parse(key.Text());
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(back->bytes(), bytes);
    std::string wrong = key.Text();
    char& digit = wrong[wrong.find("limpet-key-1 ") + 13 + random.Index(64)];
    digit = digit == 'f' ? '0' : 'f';
    EXPECT_FALSE(ShareKey::Parse(wrong));
  }
}

TEST(ShareKeyProperties, AKeyFilesBlankLinesAndCommentsDoNotMatter) {
  const ShareKey key = ShareKey::Random();
  EXPECT_EQ(ShareKey::Parse("\n# of the fleet\n\n" + key.Text() + "\n\n")->bytes(), key.bytes());
}

}  // namespace
}  // namespace limpet
