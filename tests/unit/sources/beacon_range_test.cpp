// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "estimation/navigation/aiding_sources.hpp"
#include "tests/unit/sources/sources_fixture.hpp"

namespace limpet {
namespace {

using BeaconRangeTest = SourcesTest;

TEST_F(BeaconRangeTest, RangesToABeaconHoldAVehicleThatDriftsOff) {
  velocity_error_B_ = {0.0, 0.01, 0.0};
  const Eigen::Vector3d beacon(15.0, 40.0, 12.0), transducer(0.0, 0.0, -0.3);
  Hear(Made("beacon_range", {{"at_m", "15, 40, 12"}, {"transducer_m", "0 0 -0.3"}}));
  Go(900.0, [&] { Say(0, (p_W_ + transducer - beacon).norm() + noise_.Normal(0.3)); });
  EXPECT_LT(Error(), 1.0);
  EXPECT_GT(navigator_->aiding().counts(0).taken, 800);
}

TEST_F(BeaconRangeTest, AnEchoIsRefusedAndCounted) {
  const Eigen::Vector3d beacon(15.0, 40.0, 12.0);
  Hear(Made("beacon_range", {{"at_m", "15, 40, 12"}, {"greatest_m", "200"}}));
  int second = 0;
  Go(300.0, [&] {
    const double range = (p_W_ - beacon).norm();
    ++second;
    Say(0, second % 10 == 5 ? 3.0 * range : second % 10 == 0 ? 500.0 : range);
  });
  EXPECT_LT(Error(), 0.5);
  EXPECT_EQ(navigator_->aiding().counts(0).refused, 30);
  EXPECT_GE(navigator_->aiding().counts(0).unused, 29);  // further than any beacon; one waits
}

TEST_F(BeaconRangeTest, ABeaconThatIsNotWhereItIsSaidToBeIsFoundAndMovesNobodyForSure) {
  const Eigen::Vector3d said(15.0, 40.0, 12.0), off(3.0, -3.0, 0.0);
  Hear(Made("beacon_range", {{"at_m", "15, 40, 12"}, {"at_sigma_m", "2"}}));
  Go(900.0, [&] { Say(0, (p_W_ - said - off).norm() + noise_.Normal(0.3)); });
  ExpectHonest(2.5);
  const auto errors = navigator_->aiding().ErrorsOf(0);
  ASSERT_TRUE(errors);
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(errors->value(axis), off(axis), 3.0 * errors->sd(axis));
  }
}

TEST(MeasurementSources, NonsenseIsNoObservation) {
  const auto beacon = Made("beacon_range", {});
  EXPECT_EQ(beacon->Observe(0.0, Value(-1.0)), nullptr);
  EXPECT_EQ(beacon->Observe(0.0, Value(std::nan(""))), nullptr);
  EXPECT_EQ(beacon->Observe(0.0, Value(std::string("near"))), nullptr);
  EXPECT_EQ(Made("acoustic_fix", {})->Observe(0.0, Value(std::string("north=x"))), nullptr);
}

TEST(MeasurementSources, AnUnknownNameNamesTheNearest) {
  const auto found = FindSource("beacon_rage");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().text,
            "no measurement source `beacon_rage`; did you mean `beacon_range`?");
}

}  // namespace
}  // namespace limpet
