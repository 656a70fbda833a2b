// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/key.hpp"
#include "limpet/sharing/share_key.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class KeyVerbTest : public ::testing::Test {
 protected:
  int Run(const std::string& verb) {
    const std::vector<std::string> words{verb, file_.string()};
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int code = RunKey(words);
    printed_ = ::testing::internal::GetCapturedStdout();
    complaints_ = ::testing::internal::GetCapturedStderr();
    return code;
  }
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "keys" / "fleet.key";
  std::string printed_, complaints_;
};

TEST_F(KeyVerbTest, MakesAKeyThatPShareTakes) {
  EXPECT_EQ(Run("new"), kOk);
  const auto key = LoadShareKey(file_);
  ASSERT_TRUE(key.has_value());
  EXPECT_THAT(printed_, HasSubstr(key->Fingerprint()));
  EXPECT_THAT(printed_,
              Not(HasSubstr(key->Text().substr(key->Text().find("limpet-key-1") + 13, 64))))
      << "the key itself is never printed";
}

TEST_F(KeyVerbTest, NeverWritesOverAKey) {
  ASSERT_EQ(Run("new"), kOk);
  const auto before = LoadShareKey(file_);
  EXPECT_EQ(Run("new"), kRefused);
  EXPECT_EQ(LoadShareKey(file_)->bytes(), before->bytes());
}

TEST_F(KeyVerbTest, ShowsTheFingerprintAlone) {
  ASSERT_EQ(Run("new"), kOk);
  const std::string made = printed_;
  EXPECT_EQ(Run("show"), kOk);
  EXPECT_EQ(printed_, made);
}

TEST_F(KeyVerbTest, SaysWhatIsWrongWithAKeyFile) {
  ASSERT_EQ(Run("new"), kOk);
  std::filesystem::permissions(file_, std::filesystem::perms::others_read,
                               std::filesystem::perm_options::add);
  EXPECT_EQ(Run("show"), kFailed);
  EXPECT_THAT(complaints_, HasSubstr("chmod 600"));
}

TEST(KeyVerb, SaysHowItIsUsed) {
  EXPECT_THROW(RunKey(std::vector<std::string>{"make"}), UsageError);
}

}  // namespace
}  // namespace limpet
