// SPDX-License-Identifier: MIT
// The mission `rough` as its command runs it, held to its own expect.yaml.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/survey.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

TEST(Rough, MayBeUncertainButIsNeverWrongWhenSure) {
  const TemporaryFolder folder;
  const std::vector<std::string> words{LIMPET_SOURCE_DIR "/missions/rough", "--seed", "3", "--out",
                                       (folder.path() / "run").string()};
  ::testing::internal::CaptureStdout();
  const int code = RunSurvey(words);
  const std::string out = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, kOk) << out;
  EXPECT_NE(out.find("bounds are kept"), std::string::npos) << out;
}

}  // namespace
}  // namespace limpet
