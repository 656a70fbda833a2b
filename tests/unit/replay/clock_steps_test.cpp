// SPDX-License-Identifier: MIT
#include "estimation/replay/clock_steps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

double StampOf(const StreamRow& row) {
  if (const auto* frame = std::get_if<FrameRow>(&row)) return frame->arrival;
  if (const auto* dvl = std::get_if<DvlRow>(&row)) return dvl->t;
  if (const auto* depth = std::get_if<DepthReading>(&row)) return depth->t;
  return std::get<AttitudeEstimate>(row).t;
}

/// Ten minutes of a vehicle that turns slowly; the DVL comes 0.2 s late, frames 0.3 s.
SensorStream Swim() {
  SensorStream stream;
  for (int i = 0; i < 6000; ++i) {
    const double t = 0.1 * i;
    stream.rows.emplace_back(AttitudeEstimate{.t = t, .yaw = 0.003 * t});
    stream.rows.emplace_back(DepthReading{t + 0.03, 3.0 + 0.001 * t});
    if (i % 2 == 0 && i > 2)
      stream.rows.emplace_back(DvlRow{.t = t - 0.2, .v_WD_B = {}, .altitude = {}});
    if (i % 5 == 0 && i > 5) {
      stream.rows.emplace_back(
          FrameRow{.arrival = t, .frame = {.frame = i, .exposure = Seconds(t - 0.3), .boxes = {}}});
    }
  }
  return stream;
}

/// Sets the clock by `by` [s] for what is stamped from `from` [s] until `until` comes.
void SetClock(SensorStream& stream, double from, double by, double until = 1e9) {
  for (StreamRow& row : stream.rows) {
    const double t = StampOf(row);
    if (t < from || t >= until) continue;
    if (auto* frame = std::get_if<FrameRow>(&row)) {
      frame->arrival += by;
      const double exposure = frame->frame.exposure.value();
      if (exposure >= from) frame->frame.exposure = Seconds(exposure + by);
    } else if (auto* dvl = std::get_if<DvlRow>(&row)) {
      dvl->t += by;
    } else if (auto* depth = std::get_if<DepthReading>(&row)) {
      depth->t += by;
    } else {
      std::get<AttitudeEstimate>(row).t += by;
    }
  }
}

/// Of stamps and exposures from those that they should have [s].
double GreatestError(const SensorStream& mended) {
  const SensorStream truth = Swim();
  double greatest = mended.rows.size() == truth.rows.size() ? 0.0 : 1e9;
  for (std::size_t i = 0; i < std::min(mended.rows.size(), truth.rows.size()); ++i) {
    greatest = std::max(greatest, std::abs(StampOf(mended.rows[i]) - StampOf(truth.rows[i])));
    if (const auto* frame = std::get_if<FrameRow>(&mended.rows[i])) {
      greatest = std::max(
          greatest,
          std::abs(
              (frame->frame.exposure - std::get<FrameRow>(truth.rows[i]).frame.exposure).value()));
    }
  }
  return greatest;
}

class ClockThatWasSet : public ::testing::TestWithParam<double> {};

TEST_P(ClockThatWasSet, LeavesEveryRowTheTimeThatItWouldHaveHad) {
  SensorStream stream = Swim();
  SetClock(stream, 300.0, GetParam());
  TakeOutClockSteps("run", stream);
  EXPECT_LT(GreatestError(stream), 0.15);
  EXPECT_THAT(stream.left_out, ElementsAre(HasSubstr("the clock was set")));
  EXPECT_FALSE(stream.cut);
}

TEST_P(ClockThatWasSet, MayBeSetBackAgain) {
  SensorStream stream = Swim();
  SetClock(stream, 300.0, GetParam(), 320.0);
  TakeOutClockSteps("run", stream);
  EXPECT_LT(GreatestError(stream), 0.3);
  EXPECT_EQ(stream.left_out.size(), 2U);
}

INSTANTIATE_TEST_SUITE_P(By, ClockThatWasSet,
                         ::testing::Values(-40.0, -3600.0, 3600.0, 86400.0, 1e9));

TEST(ClockSteps, AreNoneInAStreamWithoutThem) {
  SensorStream stream = Swim();
  TakeOutClockSteps("run", stream);
  EXPECT_EQ(GreatestError(stream), 0.0);
  EXPECT_THAT(stream.left_out, IsEmpty());
  EXPECT_THAT(stream.doubts, IsEmpty());
}

class ClockThatMayHaveBeenSet : public ::testing::TestWithParam<double> {};

TEST_P(ClockThatMayHaveBeenSet, IsTakenForAPauseAndSaid) {
  SensorStream stream = Swim();
  SetClock(stream, 200.0, GetParam());
  SetClock(stream, 400.0 + GetParam(), GetParam());
  TakeOutClockSteps("run", stream);
  EXPECT_NEAR(StampOf(stream.rows.back()), 600.0 + 2.0 * GetParam(), 1.0);
  EXPECT_THAT(stream.left_out, IsEmpty());
  ASSERT_THAT(stream.doubts, ElementsAre(HasSubstr("run: all sensors pause or jump ")));
  EXPECT_THAT(stream.doubts.front(), HasSubstr("s, and go on as they were: a pause or a clock"));
  EXPECT_THAT(stream.doubts.front(), HasSubstr("2 such, "));
}

INSTANTIATE_TEST_SUITE_P(By, ClockThatMayHaveBeenSet, ::testing::Values(6.0, 60.0, 590.0));

TEST(ClockSteps, ASensorThatFallsSilentForItselfIsNoDoubt) {
  SensorStream stream = Swim();
  std::erase_if(stream.rows, [](const StreamRow& row) {
    const bool is_attitude = std::holds_alternative<AttitudeEstimate>(row);
    return !is_attitude && StampOf(row) > 200.0 && StampOf(row) < 260.0;
  });
  TakeOutClockSteps("run", stream);
  EXPECT_THAT(stream.doubts, IsEmpty());
}

TEST(ClockSteps, AFewWrongStampsAreLeftToTheGates) {
  SensorStream stream = Swim();
  SetClock(stream, 300.0, 1e6, 300.15);
  const std::size_t rows = stream.rows.size();
  TakeOutClockSteps("run", stream);
  EXPECT_EQ(stream.rows.size(), rows);
  EXPECT_THAT(stream.left_out, IsEmpty());
  EXPECT_NEAR(StampOf(stream.rows.back()), StampOf(Swim().rows.back()), 1e-9);
}

TEST(ClockSteps, APauseIsAPauseAndAfterHalfAnHourAnotherDive) {
  const auto after_pause = [](double pause) {
    SensorStream stream = Swim();
    SetClock(stream, 300.0, pause);
    for (StreamRow& row : stream.rows) {
      auto* depth = std::get_if<DepthReading>(&row);
      if (depth != nullptr && depth->t >= 300.0) depth->depth += 2.0;
    }
    TakeOutClockSteps("run", stream);
    return stream;
  };
  const SensorStream bridged = after_pause(1200.0);
  EXPECT_FALSE(bridged.cut);
  EXPECT_NEAR(StampOf(bridged.rows.back()), 1800.0, 1.0);
  const SensorStream ended = after_pause(7200.0);
  ASSERT_TRUE(ended.cut);
  EXPECT_THAT(*ended.cut, HasSubstr("another dive"));
  EXPECT_NEAR(StampOf(ended.rows.back()), 300.0, 0.5);
}

TEST(ClockSteps, AFewRowsFromBeforeTheClockWasSetAreLeftOut) {
  SensorStream stream = Swim();
  SetClock(stream, 0.05, 1.5e9);  // all but the first
  const std::size_t rows = stream.rows.size();
  TakeOutClockSteps("run", stream);
  EXPECT_FALSE(stream.cut);
  EXPECT_GT(stream.rows.size(), rows - 10);
  EXPECT_GT(StampOf(stream.rows.front()), 1e9);
  EXPECT_NEAR(StampOf(stream.rows.back()), 1.5e9 + 600.0, 1.0);
  EXPECT_THAT(stream.left_out, ElementsAre(HasSubstr("stamped long before all others")));
}

TEST(ClockSteps, FurtherSensorsGoWithTheOthers) {
  SensorStream stream = Swim();
  stream.source_rows = {{.t = 100.0, .variable = "RANGE", .value = 1.0},
                        {.t = 86800.0, .variable = "RANGE", .value = 2.0}};
  SetClock(stream, 300.0, 86400.0);
  TakeOutClockSteps("run", stream);
  EXPECT_EQ(stream.source_rows[0].t, 100.0);
  EXPECT_NEAR(stream.source_rows[1].t, 400.0, 0.15);
}

}  // namespace
}  // namespace limpet
