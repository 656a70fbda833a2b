// SPDX-License-Identifier: MIT
// What pSafety is told, and what it makes of it.
#pragma once

#include <cstddef>
#include <optional>

#include <gtest/gtest.h>

#include "limpet/safety/safety_signs.hpp"

namespace limpet {

class SafetySignsTest : public testing::Test {
 protected:
  [[nodiscard]] std::optional<double> Measure(SafetyRuleId id) {
    return signs_.At(now_)[static_cast<std::size_t>(id)];
  }
  void Wait(double seconds) { now_ += Seconds(seconds); }
  void Enter(const char* phase) {
    signs_.HearPhase(phase, now_);
    static_cast<void>(signs_.At(now_));
  }
  static NavState At(double north, double down, double altitude) {
    NavState nav;
    nav.north = north;
    nav.down = down;
    nav.altitude = altitude;
    return nav;
  }
  static NavState AtPlace(double north, double east) {
    NavState nav = At(north, 3.0, 4.0);
    nav.east = east;
    return nav;
  }
  static DvlSample Velocity(double u) {
    DvlSample dvl;
    dvl.has_lock = true;
    dvl.u = u;
    dvl.v = dvl.w = 0.0;
    dvl.altitude = 4.0;
    return dvl;
  }

  SafetySigns signs_{1.0};
  Seconds now_{1000.0};
};

}  // namespace limpet
