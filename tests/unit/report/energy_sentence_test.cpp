// SPDX-License-Identifier: MIT
#include "limpet/report/energy_sentence.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(EnergySentence, SaysWhatWasUsedWhatHomeWasToTakeAndWhatIsLeft) {
  EnergyRecord energy;
  energy.Add(
      {.used_wh = 42.0, .left_wh = 360.0, .home_wh = 6.0, .capacity_wh = 400.0, .charge = 0.9},
      false);
  EXPECT_EQ(EnergySentence(energy),
            "used 42 Wh, the way home was to take about 6 Wh with the wait at the surface, 360 Wh "
            "left (90 % of 400 Wh)");
}

}  // namespace
}  // namespace limpet
