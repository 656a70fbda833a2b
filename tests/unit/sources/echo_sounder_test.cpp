// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "estimation/navigation/aiding_sources.hpp"
#include "tests/unit/sources/sources_fixture.hpp"

namespace limpet {
namespace {

using EchoSounderTest = SourcesTest;

TEST_F(EchoSounderTest, AnEchoSounderTellsTheAltitudeWhileTheDvlTellsNone) {
  Hear(Made("echo_sounder", {{"transducer_m", "0.3 0 0.2"}, {"greatest_m", "30"}}));
  Go(20.0, [] {});
  EXPECT_FALSE(navigator_->Estimate(t_).altitude);
  Go(20.0, [&] { Say(0, 6.0); });
  EXPECT_NEAR(navigator_->Estimate(t_).altitude.value(), 6.2, 1e-5);
  roll_ = 0.2;
  Go(20.0, [&] { Say(0, 6.0); });
  EXPECT_NEAR(navigator_->Estimate(t_).altitude.value(), 6.2 * std::cos(0.2), 1e-5);
  roll_ = 0.0;
  Go(20.0, [&] {
    navigator_->AddAltitude(t_, Meters(5.0));
    Say(0, 6.0);
  });
  const double dvl = 5.0 + Params().odometry.dvl_B.z();
  EXPECT_NEAR(navigator_->Estimate(t_).altitude.value(), dvl, 1e-5);
  Go(20.0, [&] { Say(0, 100.0); });  // no echo
  EXPECT_FALSE(navigator_->Estimate(t_).altitude);
  EXPECT_EQ(navigator_->aiding().counts(0).taken, 60);
}

}  // namespace
}  // namespace limpet
