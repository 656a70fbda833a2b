// SPDX-License-Identifier: MIT
#include "tests/unit/detectors/real_frames.hpp"

namespace limpet {
namespace {

using real_frames::Bound;

class ColorShapeOnRealBuoys : public testing::TestWithParam<Bound> {};

TEST_P(ColorShapeOnRealBuoys, MakesFewMistakes) {
  if (!std::filesystem::exists(real_frames::Folder("buoys"))) GTEST_SKIP() << "no real frames";
  const DetectionTally tally = real_frames::TallyBuoys("color_shape", GetParam().color);
  EXPECT_GE(tally.recall(), GetParam().recall);
  EXPECT_GE(tally.precision(), GetParam().precision);
}
INSTANTIATE_TEST_SUITE_P(Colors, ColorShapeOnRealBuoys,
                         testing::Values(Bound{"yellow", 0.97, 0.97}, Bound{"orange", 0.97, 0.97},
                                         Bound{"green", 0.9, 0.9}),
                         [](const auto& bound) { return bound.param.color; });

TEST(ColorShapeOnRealGates, SeesFewYellowOrOrangeBalls) {
  if (!std::filesystem::exists(real_frames::Folder("gate_itu/images")))
    GTEST_SKIP() << "no real frames";
  EXPECT_LE(real_frames::BoxesPerGate("color_shape", {"yellow", "orange"}), 0.15);
}

}  // namespace
}  // namespace limpet
