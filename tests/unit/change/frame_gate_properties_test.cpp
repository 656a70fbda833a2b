// SPDX-License-Identifier: MIT
// Which frames count, for any stream of them.
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "estimation/change/frame_gate.hpp"
#include "limpet/core/random.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

const FrameGate::Params kGate{.highest_view = Meters(6.5), .altitude_lasts = Seconds(5.0)};
const std::array<FrameDrop, kFrameDrops> kAllDrops{FrameDrop::kOutOfOrder, FrameDrop::kOtherPhase,
                                                   FrameDrop::kNoAltitude, FrameDrop::kTooHigh};

/// A frame as the vehicle has it.
struct GatedFrame {
  double time = 0.0;
  std::optional<double> altitude;
  std::string phase;
};

/// Mostly in order, mostly low, mostly in a phase that maps.
GatedFrame DrawFrame(Random& random, double& time) {
  time += random.Uniform(-0.5, 3.0);
  const std::array<std::string, 5> phases{"SURVEY", "DIVE", "RETURN", "ALIGN", "SURVEY"};
  return {.time = time,
          .altitude = random.Chance(0.5) ? std::optional(random.Uniform(1.0, 8.0)) : std::nullopt,
          .phase = phases[random.Index(phases.size())]};
}

FrameGate::Verdict Judged(FrameGate& gate, const GatedFrame& frame) {
  return gate.Judge(Seconds(frame.time), frame.altitude, frame.phase);
}

TEST(FrameGateProperties, EveryFrameIsCountedOnce) {
  Random random(121);
  FrameGate gate(kGate);
  double time = 0.0;
  for (int i = 1; i <= 500; ++i) {
    Judged(gate, DrawFrame(random, time));
    int counted = gate.used();
    for (const FrameDrop drop : kAllDrops)
      counted += gate.dropped(drop);
    ASSERT_EQ(counted, i);
  }
  for (const FrameDrop drop : kAllDrops)
    EXPECT_GT(gate.dropped(drop), 0) << NameOf(drop);
}

TEST(FrameGateProperties, WhatCountsIsLowKnownMappingAndLaterThanWhatWasBefore) {
  Random random(122);
  FrameGate gate(kGate);
  double time = 0.0;
  std::optional<double> last;
  for (int i = 0; i < 500; ++i) {
    const GatedFrame frame = DrawFrame(random, time);
    const FrameGate::Verdict verdict = Judged(gate, frame);
    if (!verdict.drop) {
      ASSERT_TRUE(verdict.altitude);
      EXPECT_LE(*verdict.altitude, kGate.highest_view.value());
      EXPECT_TRUE(IsMappingPhase(frame.phase));
      EXPECT_TRUE(!last || frame.time > *last);
    }
    if (verdict.drop != FrameDrop::kOutOfOrder) last = frame.time;
  }
}

TEST(FrameGateProperties, TheSameFramesLaterAreJudgedAlike) {
  for (const double later : {100.0, 1e6}) {
    Random random(123), again(123);
    FrameGate gate(kGate), other(kGate);
    double time = 0.0, other_time = 0.0;
    for (int i = 0; i < 300; ++i) {
      const GatedFrame frame = DrawFrame(random, time);
      GatedFrame moved = DrawFrame(again, other_time);
      moved.time += later;
      EXPECT_EQ(Judged(gate, frame).drop, Judged(other, moved).drop) << i;
    }
  }
}

TEST(FrameGateProperties, AnAltitudeLastsJustAsLongAsItIsSaidTo) {
  for (const double beyond : {-1e-6, 1e-6}) {
    FrameGate gate(kGate);
    gate.Hear(Seconds(10.0), 4.0);
    const auto verdict = gate.Judge(Seconds(15.0 + beyond), std::nullopt, "SURVEY");
    EXPECT_EQ(verdict.drop.has_value(), beyond > 0.0);
    EXPECT_EQ(verdict.altitude.has_value(), beyond < 0.0);
  }
}

TEST(FrameGateProperties, TheHighestViewStillCounts) {
  FrameGate gate(kGate);
  EXPECT_FALSE(gate.Judge(Seconds(1.0), 6.5, "SURVEY").drop);
  EXPECT_EQ(gate.Judge(Seconds(2.0), 6.5 + 1e-9, "SURVEY").drop, FrameDrop::kTooHigh);
}

TEST(FrameGateProperties, AFrameOutOfOrderDoesNotPutTheClockBack) {
  FrameGate gate(kGate);
  EXPECT_FALSE(gate.Judge(Seconds(10.0), 4.0, "SURVEY").drop);
  EXPECT_EQ(gate.Judge(Seconds(3.0), 4.0, "SURVEY").drop, FrameDrop::kOutOfOrder);
  EXPECT_EQ(gate.Judge(Seconds(9.0), 4.0, "SURVEY").drop, FrameDrop::kOutOfOrder);
  EXPECT_FALSE(gate.Judge(Seconds(10.5), 4.0, "SURVEY").drop);
}

TEST(FrameGateProperties, EveryReasonHasANameOfItsOwn) {
  std::string names;
  for (const FrameDrop drop : kAllDrops) {
    EXPECT_EQ(names.find(NameOf(drop)), std::string::npos);
    names += std::string(NameOf(drop)) + "\n";
  }
}

}  // namespace
}  // namespace limpet
