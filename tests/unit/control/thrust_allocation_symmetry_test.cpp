// SPDX-License-Identifier: MIT
// Both ways of every axis are alike.
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/control/thrust_allocation.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

TEST(AllocationSymmetry, TheOppositeWrenchIsMadeByOppositeThrust) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  Random random(7, "thrust");
  for (int run = 0; run < 300; ++run) {
    Wrench wanted = 40.0 * Wrench::NullaryExpr([&random] { return random.Uniform(-1.0, 1.0); });
    wanted(3) = 0.0;
    const auto there = allocation.Allocate(wanted), back = allocation.Allocate(-wanted);
    EXPECT_LT((there.command + back.command).norm(), 1e-12);
    EXPECT_EQ(there.is_saturated, back.is_saturated);
    EXPECT_LE(there.command.cwiseAbs().maxCoeff(), 1.0 + 1e-12);
    EXPECT_LT((ThrusterLayout{}.WrenchPerThrust() * there.command * ThrusterLayout{}.max_thrust_n -
               there.achieved)
                  .norm(),
              1e-9)
        << "what is said to be achieved is what these commands make";
  }
}

TEST(AllocationSymmetry, NothingIsMadeThatWasNotAskedFor) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  Random random(8, "thrust");
  for (int run = 0; run < 300; ++run) {
    Wrench wanted = 60.0 * Wrench::NullaryExpr([&random] { return random.Uniform(-1.0, 1.0); });
    wanted(3) = 0.0;
    const auto made = allocation.Allocate(wanted).achieved;
    for (int axis = 0; axis < 6; ++axis) {
      EXPECT_GE(made(axis) * wanted(axis), -1e-9) << "never the other way";
      EXPECT_LE(std::abs(made(axis)), std::abs(wanted(axis)) + 1e-9) << "never more";
    }
  }
}

}  // namespace
}  // namespace limpet
