// SPDX-License-Identifier: MIT
#include "tests/layers/parameter_lists.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/tree_files.hpp"

namespace limpet::layers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A function whose numbers nobody exchanges, and why.
struct KnownByHeart {
  std::string_view function, why;
};

constexpr std::array kKnownByHeart = {
    KnownByHeart{"RotationFromRollPitchYaw", "the name says the order"},
    KnownByHeart{"Mix", "from, to, and the share of the way"},
    KnownByHeart{"Worth", "distances that grow"},
    KnownByHeart{"LogSum", "a sum is the same either way round"},
    KnownByHeart{"Uniform", "the lower bound comes first"},
    KnownByHeart{"NumberBetween", "the lower bound comes first"},
    KnownByHeart{"DrawLog", "the lower bound comes first"},
    KnownByHeart{"NormalShareBelow", "of a distribution: where, then its parameter"},
    KnownByHeart{"StudentProbability", "of a distribution: where, then its parameter"},
    KnownByHeart{"StudentQuantile", "of a distribution: where, then its parameter"},
    KnownByHeart{"SoftPenetration", "the argument, then what rounds the function"},
};

TEST(ParameterLists, OfNoFunctionLetACallerExchangeNumbers) {
  std::vector<std::string> complaints = InterchangeableNumbers(TreeFiles());
  for (const auto& [function, why] : kKnownByHeart) {
    EXPECT_GE(std::erase_if(complaints,
                            [name = fmt::format(": {}(", function)](const std::string& complaint) {
                              return complaint.find(name) != std::string::npos;
                            }),
              1U)
        << function << " (" << why << ") need not be excused";
  }
  EXPECT_THAT(complaints, IsEmpty());
}

TEST(ParameterLists, OfTwoNumbersInARowAreComplainedAboutInAHeader) {
  const SourceFile wide{"wide.hpp",
                        "/// Of a circle.\nvoid Draw(const Canvas& canvas, double north,\n"
                        "          double east = 1.0);  // of its centre\n"};
  EXPECT_THAT(InterchangeableNumbers({wide}),
              ElementsAre("wide.hpp: Draw(const Canvas& canvas, double north, double east = 1.0)"));
}

TEST(ParameterLists, OfThreeAreComplainedAboutInWhatAFileKeepsToItself) {
  const SourceFile source{"local.cpp",
                          "double Blend(double a, double b, double share) {\n"
                          "double Half(double a, double b) {"};
  EXPECT_THAT(InterchangeableNumbers({source}),
              ElementsAre("local.cpp: Blend(double a, double b, double share)"));
}

TEST(ParameterLists, OfUnitsVectorsAndTestsAreLeftAlone) {
  const SourceFile kinds{"kinds.hpp",
                         "double At(double north, Meters down, double scale);\n"
                         "double Depth(const Eigen::Vector2d& p_W, double above);\n"
                         "void Turn(double by, bool is_port, int times);"};
  const SourceFile test{"tests/a.hpp", "double Blend(double a, double b, double share);"};
  EXPECT_THAT(InterchangeableNumbers({kinds, test}), IsEmpty());
}

}  // namespace
}  // namespace limpet::layers
