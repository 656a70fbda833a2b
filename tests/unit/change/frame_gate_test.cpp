// SPDX-License-Identifier: MIT
#include "estimation/change/frame_gate.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(FrameGate, CountsWhatItLeavesOutByReason) {
  FrameGate gate({.highest_view = Meters(6.0), .altitude_lasts = Seconds(5.0)});
  EXPECT_EQ(gate.Judge(Seconds(1.0), std::nullopt, "DIVE").drop, FrameDrop::kNoAltitude);
  EXPECT_EQ(gate.Judge(Seconds(2.0), 4.0, "ALIGN").drop, FrameDrop::kOtherPhase);
  EXPECT_EQ(gate.Judge(Seconds(3.0), 7.0, "SURVEY").drop, FrameDrop::kTooHigh);
  EXPECT_FALSE(gate.Judge(Seconds(4.0), 4.0, "SURVEY").drop);
  EXPECT_EQ(gate.Judge(Seconds(4.0), 4.0, "SURVEY").drop, FrameDrop::kOutOfOrder);
  EXPECT_EQ(gate.used(), 1);
  for (const FrameDrop drop : {FrameDrop::kNoAltitude, FrameDrop::kOtherPhase, FrameDrop::kTooHigh,
                               FrameDrop::kOutOfOrder}) {
    EXPECT_EQ(gate.dropped(drop), 1) << NameOf(drop);
  }
}

TEST(FrameGate, BridgesALostAltitudeForAWhile) {
  FrameGate gate({.highest_view = Meters(6.0), .altitude_lasts = Seconds(5.0)});
  EXPECT_FALSE(gate.Judge(Seconds(1.0), 4.0, "").drop);
  EXPECT_EQ(gate.Judge(Seconds(5.9), std::nullopt, "").altitude, 4.0);
  EXPECT_EQ(gate.Judge(Seconds(6.1), std::nullopt, "").drop, FrameDrop::kNoAltitude);
}

}  // namespace
}  // namespace limpet
