// SPDX-License-Identifier: MIT
#include "estimation/navigation/sway_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SwayModel, IsTheLeverArmBeforeAnyTurn) {
  SwayModel model(-0.3);
  EXPECT_DOUBLE_EQ(model.per_rate(), -0.3);
  for (int i = 0; i < 1000; ++i)
    model.Add(0.05, 0.0, 0.2);
  EXPECT_DOUBLE_EQ(model.per_rate(), -0.3) << "a current abeam says nothing about turning";
}

TEST(SwayModel, LearnsWhatTurningBrings) {
  SwayModel model(-0.3);
  for (int i = 0; i < 1000; ++i) {
    const double rate = 0.2 * std::sin(0.1 * i);
    model.Add(-0.5 * rate, rate, 0.2);
  }
  EXPECT_NEAR(model.per_rate(), -0.5, 0.01);
}

TEST(SwayModel, ForgetsALoadThatIsGone) {
  SwayModel model(0.0);
  for (int i = 0; i < 3000; ++i)
    model.Add(-0.5 * 0.1, 0.1, 0.2);
  for (int i = 0; i < 12000; ++i)
    model.Add(-0.2 * 0.1, 0.1, 0.2);
  EXPECT_NEAR(model.per_rate(), -0.2, 0.02);
}

}  // namespace
}  // namespace limpet
