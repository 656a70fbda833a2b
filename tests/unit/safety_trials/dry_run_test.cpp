// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/dry_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/sound_flight.hpp"

namespace limpet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(DryFlight, ThatComesHomeWithItsReserveHasNoObjections) {
  EXPECT_THAT(SoundFlight().Objections(), IsEmpty());
}

TEST(DryFlight, SaysWhichRuleTrippedWhenAndWhere) {
  DryFlight flight = SoundFlight();
  flight.tripped.push_back({.rule = "depth_over_limit",
                            .action = "surface",
                            .phase = "DIVE",
                            .after_s = 61.0,
                            .north_m = -12.5,
                            .east_m = 3.0,
                            .down_m = 2.6});
  EXPECT_THAT(flight.Objections(),
              ElementsAre("rule depth_over_limit asks for surface after 61 s in DIVE, north -12.5, "
                          "east 3.0 m, 2.6 m deep"));
}

TEST(DryFlight, IsRefusedForAnEmptyBatteryAReserveNotKeptAndAnEndElsewhere) {
  DryFlight flight = SoundFlight();
  flight.energy->left_wh = 50.0;
  EXPECT_THAT(flight.Objections(),
              ElementsAre("50 Wh left at the end, of which 60 Wh were to be in reserve"));
  flight.energy->is_off = true;
  EXPECT_THAT(flight.Objections(), ElementsAre("the battery is empty after 20 Wh"));
  flight = SoundFlight();
  flight.ended = "timeout";
  flight.home_error_m = 40.0;
  flight.down_m = 3.0;
  EXPECT_THAT(flight.Objections(),
              ElementsAre("it ended `timeout` after 900 s",
                          "it did not come home: 40 m from the start, 3.0 m deep at the end"));
}

TEST(DryFlight, IsNotRefusedForAWarningButSaysIt) {
  DryFlight flight = SoundFlight();
  flight.tripped.push_back({.rule = "clock_stepped", .action = "warn", .phase = "SURVEY"});
  EXPECT_THAT(flight.Objections(), IsEmpty());
  EXPECT_THAT(flight.Remarks(), ElementsAre(HasSubstr("rule clock_stepped asks for warn after")));
  for (const char* action : {"degrade", "hold", "return", "surface", "abort"}) {
    flight.tripped.front().action = action;
    EXPECT_THAT(flight.Objections(), ElementsAre(HasSubstr(action)));
    EXPECT_THAT(flight.Remarks(), IsEmpty());
  }
}

}  // namespace
}  // namespace limpet
