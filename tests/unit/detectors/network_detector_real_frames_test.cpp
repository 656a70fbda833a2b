// SPDX-License-Identifier: MIT
#include "tests/unit/detectors/real_frames.hpp"

namespace limpet {
namespace {

using real_frames::Bound;

class NetworkOnRealBuoys : public testing::TestWithParam<Bound> {};

TEST_P(NetworkOnRealBuoys, MakesFewMistakes) {
  if (!std::filesystem::exists(real_frames::Folder("buoys"))) GTEST_SKIP() << "no real frames";
  const DetectionTally tally = real_frames::TallyBuoys("network", GetParam().color);
  EXPECT_GE(tally.recall(), GetParam().recall);
  EXPECT_GE(tally.precision(), GetParam().precision);
}
INSTANTIATE_TEST_SUITE_P(Colors, NetworkOnRealBuoys,
                         testing::Values(Bound{"yellow", 0.97, 0.97}, Bound{"orange", 0.97, 0.97},
                                         Bound{"green", 0.97, 0.97}),
                         [](const auto& bound) { return bound.param.color; });

TEST(NetworkOnRealGates, SeesHardlyAnyBall) {
  if (!std::filesystem::exists(real_frames::Folder("gate_itu/images")))
    GTEST_SKIP() << "no real frames";
  EXPECT_LE(real_frames::BoxesPerGate("network", {}), 0.05);
}

}  // namespace
}  // namespace limpet
