// SPDX-License-Identifier: MIT
#include "estimation/change/sight_gate.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SightGate, CountsWhatItLeavesOutByReason) {
  SightGate gate({.highest_view = Meters(6.0), .altitude_lasts = Seconds(5.0)});
  EXPECT_EQ(gate.Judge(Seconds(1.0), std::nullopt, "DIVE").drop, SightDrop::kNoAltitude);
  EXPECT_EQ(gate.Judge(Seconds(2.0), 4.0, "ALIGN").drop, SightDrop::kOtherPhase);
  EXPECT_EQ(gate.Judge(Seconds(3.0), 7.0, "SURVEY").drop, SightDrop::kTooHigh);
  EXPECT_FALSE(gate.Judge(Seconds(4.0), 4.0, "SURVEY").drop);
  EXPECT_EQ(gate.Judge(Seconds(4.0), 4.0, "SURVEY").drop, SightDrop::kOutOfOrder);
  EXPECT_EQ(gate.used(), 1);
  for (const SightDrop drop : {SightDrop::kNoAltitude, SightDrop::kOtherPhase, SightDrop::kTooHigh,
                               SightDrop::kOutOfOrder}) {
    EXPECT_EQ(gate.dropped(drop), 1) << NameOf(drop);
  }
}

TEST(SightGate, BridgesALostAltitudeForAWhile) {
  SightGate gate({.highest_view = Meters(6.0), .altitude_lasts = Seconds(5.0)});
  EXPECT_FALSE(gate.Judge(Seconds(1.0), 4.0, "").drop);
  EXPECT_EQ(gate.Judge(Seconds(5.9), std::nullopt, "").altitude, 4.0);
  EXPECT_EQ(gate.Judge(Seconds(6.1), std::nullopt, "").drop, SightDrop::kNoAltitude);
}

}  // namespace
}  // namespace limpet
