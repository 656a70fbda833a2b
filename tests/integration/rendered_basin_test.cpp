// SPDX-License-Identifier: MIT
// The command of the README on the small mission, with camera images and the detector on them.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apps/limpet/verbs/survey.hpp"
#include "limpet/console/exit_code.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

TEST(RenderedBasin, IsSurveyedTwiceWithinTheBoundsOfItsExpectations) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "run";
  const std::vector<std::string> words{LIMPET_SOURCE_DIR "/missions/basin", "--out", out.string()};
  EXPECT_EQ(RunSurvey(words), kOk);
  EXPECT_TRUE(std::filesystem::exists(out / "report.html"));
}

}  // namespace
}  // namespace limpet
