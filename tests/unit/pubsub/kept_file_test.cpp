// SPDX-License-Identifier: MIT
// What was kept is there again whenever the process ends.
#include "limpet/pubsub/kept_file.hpp"

#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "limpet/core/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

constexpr std::size_t kHalf = 1000;

ByteBuffer BytesOfText(const std::string& text) {
  const auto* data = reinterpret_cast<const std::byte*>(text.data());
  return {data, data + text.size()};
}

class KeptFileTest : public ::testing::Test {
 protected:
  KeptFileTest() : descriptor_(::open(file_.c_str(), O_RDWR | O_CREAT, 0600)) {}
  ~KeptFileTest() override { ::close(descriptor_); }
  KeptFileTest(const KeptFileTest&) = delete;
  KeptFileTest& operator=(const KeptFileTest&) = delete;

  /// What the next process finds.
  [[nodiscard]] ByteBuffer Found() const { return KeptFile(descriptor_, kHalf).Load(); }

  TemporaryFolder folder_;
  std::string file_ = folder_.path() / "kept";
  int descriptor_;
};

TEST_F(KeptFileTest, ANewFileHoldsNothing) {
  KeptFile kept(descriptor_, kHalf);
  EXPECT_EQ(kept.size(), 0U);
  EXPECT_EQ(kept.limit(), kHalf);
  EXPECT_TRUE(kept.Load().empty());
}

TEST_F(KeptFileTest, AfterEveryStepTheNextProcessFindsAllOfIt) {
  Random random(95);
  KeptFile kept(descriptor_, kHalf);
  ByteBuffer expected;
  for (int i = 0; i < 300; ++i) {
    const ByteBuffer bytes =
        BytesOfText(std::string(random.Index(120), static_cast<char>('a' + i % 26)));
    if (random.Chance(0.8)) {
      const bool fits = expected.size() + bytes.size() <= kHalf;
      ASSERT_EQ(kept.Append(bytes), fits) << i;
      if (fits) expected.insert(expected.end(), bytes.begin(), bytes.end());
    } else {
      ASSERT_TRUE(kept.Rewrite(bytes)) << i;
      expected = bytes;
    }
    ASSERT_EQ(Found(), expected) << i;
    EXPECT_EQ(kept.size(), expected.size());
  }
}

TEST_F(KeptFileTest, HoldsJustAsMuchAsItsLimit) {
  KeptFile kept(descriptor_, kHalf);
  EXPECT_TRUE(kept.Append(BytesOfText(std::string(kHalf, 'x'))));
  EXPECT_FALSE(kept.Append(BytesOfText("y")));
  EXPECT_TRUE(kept.Append({}));
  EXPECT_EQ(Found(), BytesOfText(std::string(kHalf, 'x')));
  EXPECT_FALSE(kept.Rewrite(BytesOfText(std::string(kHalf + 1, 'z'))));
  EXPECT_EQ(Found(), BytesOfText(std::string(kHalf, 'x'))) << "a refused rewrite changes nothing";
  EXPECT_TRUE(kept.Rewrite(BytesOfText(std::string(kHalf, 'z'))));
  EXPECT_EQ(Found(), BytesOfText(std::string(kHalf, 'z')));
}

TEST_F(KeptFileTest, WhatWasBeingWrittenWhenTheProcessDiedIsNotThere) {
  KeptFile kept(descriptor_, kHalf);
  ASSERT_TRUE(kept.Append(BytesOfText("before")));
  // The bytes of an append, and of a rewrite, whose header never came.
  const std::string half = "half a message";
  ASSERT_EQ(::pwrite(descriptor_, half.data(), half.size(), 4096 + 6),
            static_cast<ssize_t>(half.size()));
  ASSERT_EQ(::pwrite(descriptor_, half.data(), half.size(), 4096 + kHalf),
            static_cast<ssize_t>(half.size()));
  EXPECT_EQ(Found(), BytesOfText("before"));
}

TEST_F(KeptFileTest, AHeaderThatIsNoneIsAnEmptyFile) {
  Random random(96);
  for (int i = 0; i < 200; ++i) {
    KeptFile kept(descriptor_, kHalf);
    ASSERT_TRUE(kept.Rewrite(BytesOfText("something")));
    const auto byte = static_cast<unsigned char>(random.Index(256));
    const auto place = static_cast<off_t>(random.Index(16));
    ASSERT_EQ(::pwrite(descriptor_, &byte, 1, place), 1);
    const KeptFile found(descriptor_, kHalf);
    EXPECT_LE(found.size(), kHalf) << "byte " << place << " became " << int{byte};
    EXPECT_LE(found.Load().size(), kHalf);
  }
}

TEST_F(KeptFileTest, AFileThatLostItsEndGivesWhatIsLeft) {
  KeptFile kept(descriptor_, kHalf);
  ASSERT_TRUE(kept.Append(BytesOfText("abcdefghij")));
  ASSERT_EQ(::ftruncate(descriptor_, 4096 + 4), 0);
  EXPECT_EQ(Found(), BytesOfText("abcd"));
}

TEST_F(KeptFileTest, AFileThatCannotBeWrittenSaysSoAndKeepsWhatItHas) {
  ASSERT_TRUE(KeptFile(descriptor_, kHalf).Append(BytesOfText("before")));
  const int read_only = ::open(file_.c_str(), O_RDONLY);
  KeptFile kept(read_only, kHalf);
  EXPECT_FALSE(kept.Append(BytesOfText("more")));
  EXPECT_FALSE(kept.Rewrite(BytesOfText("other")));
  EXPECT_EQ(kept.Load(), BytesOfText("before"));
  ::close(read_only);
}

}  // namespace
}  // namespace limpet
