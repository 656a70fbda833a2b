// SPDX-License-Identifier: MIT
#include "tests/layers/parameter_lists.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/tree_files.hpp"

namespace limpet::layers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ParameterLists, OfNoFunctionLetACallerExchangeThreeNumbers) {
  EXPECT_THAT(InterchangeableNumbers(TreeFiles()), IsEmpty());
}

TEST(ParameterLists, OfThreeNumbersInARowAreComplainedAbout) {
  const SourceFile wide{
      "wide.hpp",
      "/// Of a circle.\nvoid Draw(const Canvas& canvas, double north,\n"
      "          double east,  // of its centre\n          double radius = 1.0);"};
  EXPECT_THAT(InterchangeableNumbers({wide}),
              ElementsAre("wide.hpp: Draw(const Canvas& canvas, double north, double east, double "
                          "radius = 1.0)"));
}

TEST(ParameterLists, OfWhatAFileKeepsToItselfCountToo) {
  const SourceFile source{"local.cpp", "double Blend(double a, double b, double share) {"};
  EXPECT_THAT(InterchangeableNumbers({source}),
              ElementsAre("local.cpp: Blend(double a, double b, double share)"));
}

TEST(ParameterLists, OfPairsUnitsAndTestsAreLeftAlone) {
  const SourceFile pairs{"pairs.hpp",
                         "double At(double north, double east, Meters down, double scale);\n"
                         "Matrix RotationFromRollPitchYaw(double roll, double pitch, double yaw);"};
  const SourceFile test{"tests/a.cpp", "double Blend(double a, double b, double share) {"};
  EXPECT_THAT(InterchangeableNumbers({pairs, test}), IsEmpty());
}

}  // namespace
}  // namespace limpet::layers
