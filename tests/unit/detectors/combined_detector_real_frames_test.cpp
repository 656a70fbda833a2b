// SPDX-License-Identifier: MIT
#include "tests/unit/detectors/real_frames.hpp"

namespace limpet {
namespace {

using real_frames::Bound;

class CombinedOnRealBuoys : public testing::TestWithParam<Bound> {};

TEST_P(CombinedOnRealBuoys, MakesFewMistakes) {
  if (!std::filesystem::exists(real_frames::Folder("buoys"))) GTEST_SKIP() << "no real frames";
  const DetectionTally tally = real_frames::TallyBuoys("combined", GetParam().color);
  EXPECT_GE(tally.recall(), GetParam().recall);
  EXPECT_GE(tally.precision(), GetParam().precision);
}
INSTANTIATE_TEST_SUITE_P(Colors, CombinedOnRealBuoys,
                         testing::Values(Bound{"yellow", 0.97, 0.97}, Bound{"orange", 0.97, 0.97},
                                         Bound{"green", 0.9, 0.97}),
                         [](const auto& bound) { return bound.param.color; });

TEST(CombinedOnRealGates, SeesHardlyAnyBall) {
  if (!std::filesystem::exists(real_frames::Folder("gate_itu/images")))
    GTEST_SKIP() << "no real frames";
  EXPECT_LE(real_frames::BoxesPerGate("combined", {}), 0.1);
}

}  // namespace
}  // namespace limpet
