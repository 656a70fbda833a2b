// SPDX-License-Identifier: MIT
// pDetect's block in a mission file: the app's keys and those of the detector that it names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/registry.hpp"
#include "limpet/core/config.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ConfigBlock Block(const std::vector<std::pair<std::string, std::string>>& lines) {
  ConfigBlock block{.name = "pDetect", .where = {"m.moos", 1}, .entries = {}};
  for (const auto& [key, value] : lines) {
    block.entries.push_back({key, value, {"m.moos", static_cast<int>(block.entries.size()) + 2}});
  }
  return block;
}

std::string ProblemsOf(const std::vector<std::pair<std::string, std::string>>& lines) {
  std::string text;
  for (const ConfigProblem& problem : AppRegistry().at("pDetect").check(Block(lines))) {
    text += problem.Format() + "\n";
  }
  return text;
}

TEST(DetectBlock, TakesTheKeysOfItsDetector) {
  EXPECT_THAT(ProblemsOf({{"detector", "color_shape"},
                          {"least_radius_px", "12"},
                          {"min_confidence", "0.5"},
                          {"AppTick", "4"}}),
              IsEmpty());
}

TEST(DetectBlock, ChecksTheRangeOfADetectorsKey) {
  EXPECT_THAT(ProblemsOf({{"least_radius_px", "-1"}}),
              HasSubstr("m.moos:2: least_radius_px: `-1` is not allowed; allowed: 2 to 1000"));
}

TEST(DetectBlock, NamesTheNearestOfAMisspeltKeyOfTheDetector) {
  EXPECT_THAT(ProblemsOf({{"least_radus_px", "12"}}), HasSubstr("did you mean `least_radius_px`?"));
}

TEST(DetectBlock, RefusesAnUnknownDetectorOnceAndNamesTheNearest) {
  const std::string problems = ProblemsOf({{"detector", "color_shpe"}, {"least_radius_px", "12"}});
  EXPECT_THAT(problems, AllOf(HasSubstr("m.moos:2: detector: `color_shpe` is not allowed"),
                              HasSubstr("did you mean `color_shape`?")));
  EXPECT_EQ(std::ranges::count(problems, '\n'), 1) << problems;
}

TEST(DetectBlock, WithAProblemMakesNoApp) {
  TestLink link;
  AppContext context;
  context.name = "pDetect";
  context.link = &link;
  const auto& create = AppRegistry().at("pDetect").create;
  EXPECT_THROW(create(context, Block({{"detector", "nothing_like_it"}})), ConfigError);
  EXPECT_THROW(create(context, Block({{"least_radius_px", "none"}})), ConfigError);
  EXPECT_NE(create(context, Block({{"least_radius_px", "12"}})), nullptr);
}

}  // namespace
}  // namespace limpet
