// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_key.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class ShareKeyTest : public ::testing::Test {
 protected:
  std::string Trouble() const {
    const auto key = LoadShareKey(file_);
    return key ? "" : key.error().text;
  }
  void Write(const std::string& text) const {
    std::ofstream(file_) << text;
    fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write);
  }
  TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "fleet.key";
  ShareKey key_ = ShareKey::Random();
};

TEST_F(ShareKeyTest, ComesBackFromItsFile) {
  ASSERT_FALSE(SaveShareKey(key_, file_));
  const auto loaded = LoadShareKey(file_);
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->bytes(), key_.bytes());
}

TEST_F(ShareKeyTest, FileIsItsOwnersAlone) {
  ASSERT_FALSE(SaveShareKey(key_, file_));
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(ShareKeyTest, SaysHowOneIsMadeIfThereIsNone) {
  EXPECT_THAT(Trouble(), HasSubstr("`limpet key new " + file_.string()));
}

TEST_F(ShareKeyTest, IsNeverWrittenOver) {
  ASSERT_FALSE(SaveShareKey(key_, file_));
  EXPECT_TRUE(SaveShareKey(ShareKey::Random(), file_).has_value());
  EXPECT_EQ(LoadShareKey(file_)->bytes(), key_.bytes());
}

TEST_F(ShareKeyTest, IsRefusedIfOthersMayReadIt) {
  ASSERT_FALSE(SaveShareKey(key_, file_));
  fs::permissions(file_, fs::perms::group_read, fs::perm_options::add);
  EXPECT_THAT(Trouble(), HasSubstr("chmod 600"));
}

TEST_F(ShareKeyTest, IsRefusedIfItIsNoRegularFile) {
  fs::create_directory(file_);
  EXPECT_THAT(Trouble(), HasSubstr("no regular file"));
  fs::remove(file_);
  ASSERT_EQ(::mkfifo(file_.c_str(), S_IRUSR | S_IWUSR), 0);
  EXPECT_THAT(Trouble(), HasSubstr("no regular file")) << "and nobody waits for a writer";
}

TEST_F(ShareKeyTest, IsRefusedWithAWrongDigit) {
  std::string text = key_.Text();
  char& digit = text[text.find("limpet-key-1 ") + 20];
  digit = digit == '0' ? '1' : '0';
  Write(text);
  EXPECT_THAT(Trouble(), HasSubstr("a digit is wrong"));
}

TEST_F(ShareKeyTest, SaysWhatAKeyFileLooksLike) {
  Write("secret\n");
  EXPECT_THAT(Trouble(), HasSubstr("limpet-key-1 <64 hexadecimal digits>"));
  Write("# nothing\n");
  EXPECT_THAT(Trouble(), HasSubstr("no key"));
  Write(std::string(100'000, 'x'));
  EXPECT_THAT(Trouble(), HasSubstr("too large"));
}

TEST_F(ShareKeyTest, FingerprintTellsKeysApart) {
  EXPECT_EQ(key_.Fingerprint().size(), 8U);
  EXPECT_NE(key_.Fingerprint(), ShareKey::Random().Fingerprint());
  EXPECT_EQ(key_.Text().find(key_.Fingerprint()), key_.Text().rfind(' ') + 1);
}

}  // namespace
}  // namespace limpet
