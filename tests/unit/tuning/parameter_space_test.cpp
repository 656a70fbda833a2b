// SPDX-License-Identifier: MIT
#include "limpet/tuning/parameter_space.hpp"

#include <set>

#include <gtest/gtest.h>

namespace limpet {
namespace {

ParameterSpace Square() {
  return ParameterSpace({*VariedParameter::Parse("a.x=0:10"), *VariedParameter::Parse("a.y=0:1")});
}

TEST(ParameterSpace, ReadsWhatIsVaried) {
  const auto parameter = VariedParameter::Parse("cover.frontier_weight=0:1:5");
  ASSERT_TRUE(parameter);
  EXPECT_EQ(parameter->name, "cover.frontier_weight");
  EXPECT_EQ(parameter->ValueAt(0.3), 0.25);
  EXPECT_EQ(parameter->ValueAt(2.0), 1.0);
  EXPECT_EQ(parameter->Text(), "cover.frontier_weight=0:1:5");
  EXPECT_EQ(VariedParameter::Parse("a.b=0:1:11")->ValueAt(0.3), 0.3);
  for (const char* wrong : {"", "a.b", "a=0:1", ".b=0:1", "a.=0:1", "a.b=1", "a.b=2:1", "a.b=1:1",
                            "a.b=x:1", "a.b=0:1:1", "a.b=0:1:5000", "a.b=0:1:2:3"}) {
    EXPECT_FALSE(VariedParameter::Parse(wrong)) << wrong;
  }
}

TEST(ParameterSpace, MakesAGridOfAllLevels) {
  const ParameterSpace space(
      {*VariedParameter::Parse("a.x=0:1:2"), *VariedParameter::Parse("a.y=0:4")});
  const auto grid = space.Grid();
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->size(), 10U);
  EXPECT_EQ((*grid)[1], (SettingValues{0.0, 1.0}));
  EXPECT_EQ(space.TextsOf((*grid)[9]), (std::vector<std::string>{"a.x=1", "a.y=4"}));
  std::vector<VariedParameter> many(9, *VariedParameter::Parse("a.x=0:1:10"));
  EXPECT_FALSE(ParameterSpace(many).Grid());
}

TEST(ParameterSpace, SpreadsSettingsOverEveryPartOfEachRange) {
  const std::vector<SettingValues> spread = Square().Spread(10, 3);
  ASSERT_EQ(spread.size(), 10U);
  std::set<int> parts;
  for (const SettingValues& setting : spread)
    parts.insert(static_cast<int>(setting[0]));
  EXPECT_EQ(parts.size(), 10U);
  EXPECT_EQ(Square().Spread(10, 3), spread);
}

}  // namespace
}  // namespace limpet
