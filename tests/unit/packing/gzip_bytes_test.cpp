// SPDX-License-Identifier: MIT
#include "limpet/packing/gzip_bytes.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

std::string Drawn(Random& random, std::size_t size) {
  std::string bytes;
  while (bytes.size() < size) {
    bytes.append(1 + random.Index(30), static_cast<char>(random.Index(256)));
  }
  return bytes.substr(0, size);
}

TEST(Gzip, ComesBackTheSameWhateverItHeld) {
  Random random(5, "gzip");
  for (const std::size_t size : {0U, 1U, 100U, 65'536U, 1'000'000U}) {
    const std::string bytes = Drawn(random, size);
    for (const Packing packing : {Packing::kFast, Packing::kSmall}) {
      const std::string packed = Gzip(bytes, packing);
      EXPECT_TRUE(IsGzip(packed));
      const Expected<std::string> back = Gunzip(packed, size);
      ASSERT_TRUE(back) << back.error().text;
      EXPECT_TRUE(*back == bytes);
    }
  }
}

TEST(Gzip, StopsAtItsBudget) {
  const std::string bomb = Gzip(std::string(50'000'000, 'a'));
  EXPECT_LT(bomb.size(), 100'000U);
  const Expected<std::string> back = Gunzip(bomb, 1'000'000);
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().text, "is longer than 1000000 bytes");
}

TEST(Gzip, SaysWhatIsDamagedOrCutShort) {
  Random random(6, "gzip");
  const std::string packed = Gzip(Drawn(random, 5'000));
  for (std::size_t cut = 0; cut < packed.size(); cut += 7) {
    EXPECT_FALSE(Gunzip(packed.substr(0, cut), 5'000)) << cut;
  }
  int damaged = 0;
  for (std::size_t at = 10; at < packed.size(); at += 5) {
    std::string spoilt = packed;
    spoilt[at] = static_cast<char>(spoilt[at] ^ 0x55);
    damaged += Gunzip(spoilt, 5'000) ? 0 : 1;
  }
  EXPECT_GT(damaged, 0);
  EXPECT_FALSE(Gunzip("no gzip at all", 5'000));
}

}  // namespace
}  // namespace limpet
