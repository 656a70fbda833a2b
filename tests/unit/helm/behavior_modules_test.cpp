// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_modules.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/behavior_abi.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

class BehaviorModules : public ::testing::Test {
 protected:
  void SetUp() override { ::unsetenv(kBehaviorPathVariable); }
  void Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << bytes;
  }
  /// What the helm says of folders; empty if it takes all that is in them.
  [[nodiscard]] std::string ComplaintOf(const std::string& folders = ".") const {
    const ConfigEntry line{
        .key = "behavior_path", .value = folders, .where = {.file = "mission.moos", .line = 12}};
    try {
      LoadBehaviorModules({&line, 1}, folder_.path());
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(BehaviorModules, OfAnotherVersionAreRefusedWithoutBeingLoaded) {
  Write("libBHV_Old.so", std::string("\x7f\x45LF\0", 5) + "LIMPET_BEHAVIOR_ABI 0, c++ 1");
  const std::string complaint = ComplaintOf();
  EXPECT_THAT(complaint, HasSubstr("mission.moos:12: behavior_path"));
  EXPECT_THAT(complaint, HasSubstr("libBHV_Old.so"));
  EXPECT_THAT(complaint, HasSubstr("`LIMPET_BEHAVIOR_ABI 0, c++ 1`"));
  EXPECT_THAT(complaint, HasSubstr("build it again"));
}

TEST_F(BehaviorModules, OfSomethingElseAreRefused) {
  Write("libBHV_Foreign.so", "no object at all");
  EXPECT_THAT(ComplaintOf(), HasSubstr("built against something that is no Limpet"));
}

TEST_F(BehaviorModules, ThatCannotBeLoadedAreRefusedWithTheLoadersReason) {
  Write("libBHV_Torn.so", LIMPET_BEHAVIOR_ABI_MARK);
  EXPECT_THAT(ComplaintOf(), HasSubstr("libBHV_Torn.so"));
}

TEST_F(BehaviorModules, AreLookedForInFoldersThatExist) {
  EXPECT_THAT(ComplaintOf("nowhere"), HasSubstr("nowhere"));
  ::setenv(kBehaviorPathVariable, "/no/such/folder", 1);
  EXPECT_THAT(ComplaintOf(), HasSubstr("LIMPET_BEHAVIOR_PATH: `/no/such/folder`"));
  ::unsetenv(kBehaviorPathVariable);
}

TEST_F(BehaviorModules, AreTheOnlyFilesThatAreTouched) {
  Write("libOther.so", "not ours");
  Write("BHV_Text.so", "not ours");
  Write("libBHV_Notes.txt", "not ours");
  EXPECT_EQ(ComplaintOf(), "");
  EXPECT_EQ(ComplaintOf(""), "");
  EXPECT_EQ(ComplaintOf(".:."), "");
}

}  // namespace
}  // namespace limpet
