// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "estimation/navigation/aiding_sources.hpp"
#include "tests/unit/sources/sources_fixture.hpp"

namespace limpet {
namespace {

using AcousticFixTest = SourcesTest;

TEST_F(AcousticFixTest, AcousticFixesReplaceGpsUnderWater) {
  velocity_error_B_ = {0.02, 0.02, 0.0};
  Hear(Made("acoustic_fix", {{"sigma_m", "0.8"}, {"constant_sigma_m", "0.2"}}));
  Go(900.0, [&] { SayFix(p_W_); });
  ExpectHonest(1.0);
}

TEST_F(AcousticFixTest, FixesThatAreAllOffByTheSameMoveNobodyForSure) {
  const Eigen::Vector3d off(-2.5, 2.0, 0.0);
  Hear(Made("acoustic_fix", {{"sigma_m", "0.8"}, {"constant_sigma_m", "2"}}));
  Go(900.0, [&] { SayFix(p_W_ + off); });
  ExpectHonest(1.0);
  const auto errors = navigator_->aiding().ErrorsOf(0);
  ASSERT_TRUE(errors);
  EXPECT_NEAR(errors->value.x(), off.x(), 3.0 * errors->sd.x());
  // One fix of 0.5 m, from a receiver that may be worse than it states.
  EXPECT_LT(errors->sd.x(), 1.2) << "where it dived the receiver knew";
}

}  // namespace
}  // namespace limpet
