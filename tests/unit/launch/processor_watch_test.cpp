// SPDX-License-Identifier: MIT
#include "limpet/launch/processor_watch.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// A helm that takes `helm` and a map that takes `map` of a core.
void Look(ProcessorWatch& watch, double helm, double map, double now) {
  watch.Hear({{.name = "pHelm", .pid = 11, .used = Seconds(helm * now)},
              {.name = "pMap", .pid = 12, .used = Seconds(map * now)}},
             Seconds(now));
}

TEST(ProcessorWatch, NamesTheBusiestProcessOnceItHasSeenItWork) {
  ProcessorWatch watch(1.0);
  EXPECT_FALSE(watch.busiest());
  Look(watch, 0.1, 0.5, 100.0);
  EXPECT_FALSE(watch.busiest()) << "what it did before is no share of anything";
  for (double now = 105.0; now < 300.0; now += 5.0) {
    Look(watch, 0.1, 0.5, now);
  }
  EXPECT_EQ(watch.busiest()->app, "pMap");
  EXPECT_NEAR(watch.busiest()->percent, 50.0, 0.1);
}

TEST(ProcessorWatch, DoesNotTakeOneLongDecisionForALoad) {
  ProcessorWatch watch(1.0);
  watch.Hear({{.name = "pHelm", .pid = 11, .used = Seconds(10.0)}}, Seconds(100.0));
  watch.Hear({{.name = "pHelm", .pid = 11, .used = Seconds(15.0)}}, Seconds(105.0));
  EXPECT_NEAR(watch.busiest()->percent, 22.1, 0.1);
  for (double now = 110.0; now < 170.0; now += 5.0) {
    watch.Hear({{.name = "pHelm", .pid = 11, .used = Seconds(now - 90.0)}}, Seconds(now));
  }
  EXPECT_GT(watch.busiest()->percent, 90.0) << "after a minute it is one";
}

TEST(ProcessorWatch, CountsByVehicleTime) {
  ProcessorWatch watch(10.0);
  for (double now = 0.0; now < 200.0; now += 5.0) {
    Look(watch, 0.9, 0.2, now);
  }
  EXPECT_NEAR(watch.busiest()->percent, 9.0, 0.1);
}

TEST(ProcessorWatch, BeginsAnewWithAProcessThatWasStartedAgain) {
  ProcessorWatch watch(1.0);
  watch.Hear({{.name = "pHelm", .pid = 11, .used = Seconds(50.0)}}, Seconds(100.0));
  watch.Hear({{.name = "pHelm", .pid = 11, .used = Seconds(55.0)}}, Seconds(105.0));
  watch.Hear({{.name = "pHelm", .pid = 12, .used = Seconds(0.1)}}, Seconds(110.0));
  EXPECT_FALSE(watch.busiest());
}

}  // namespace
}  // namespace limpet
