// SPDX-License-Identifier: MIT
#include "limpet/energy/energy_estimate.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// A vehicle that goes at 0.5 m/s, or lies still, and draws what it is told.
class Flight {
 public:
  explicit Flight(double charge = 0.9) : charge_(charge) {}
  /// `of_gauge`: what the gauge shows of what is drawn.
  void Fly(double seconds, double power_w, double speed_mps, double of_gauge = 1.0) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds)); ++i) {
      NavState nav;
      nav.u = speed_mps;
      now_ += Seconds(1.0);
      estimate_.Hear(nav, now_);
      const double share = power_w / 3600.0 / sheet_.capacity_wh;
      charge_ -= share;
      said_ -= of_gauge * share;
      estimate_.Hear(Say(power_w), now_);
    }
  }
  void FlyWithoutVoltage(double seconds, double dropped) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds)); ++i) {
      now_ += Seconds(1.0);
      charge_ -= dropped / seconds;
      estimate_.Hear(BatteryState{.charge = charge_, .volts = {}, .amperes = {}}, now_);
    }
  }
  [[nodiscard]] EnergyState At(double distance_m) const {
    return *estimate_.At({.distance = Meters(distance_m),
                          .depth = Meters(3.0),
                          .at_surface = Seconds(300.0),
                          .reserve_share = 0.15});
  }
  [[nodiscard]] const BatterySheet& sheet() const { return sheet_; }

 private:
  [[nodiscard]] BatteryState Say(double power_w) const {
    const double volts = sheet_.OpenCircuitVolts(charge_);
    return {.charge = said_, .volts = volts, .amperes = power_w / volts};
  }

  BatterySheet sheet_;
  EnergyEstimate estimate_{VehicleParams{}, sheet_};
  double charge_;
  double said_ = charge_;
  Seconds now_{100.0};
};

TEST(EnergyEstimate, KnowsNothingBeforeABatteryWasHeard) {
  const EnergyEstimate estimate(VehicleParams{}, BatterySheet{});
  EXPECT_FALSE(estimate.At({}));
}

TEST(EnergyEstimate, BeginsWithTheSheetsAndAMargin) {
  Flight flight;
  flight.Fly(1.0, 80.0, 0.0);
  const EnergyState state = flight.At(100.0);
  EXPECT_LT(state.capacity_wh, 0.9 * flight.sheet().capacity_wh);
  const double by_sheet_w =
      WayPower(VehicleParams{}, flight.sheet()).Cruising(MetersPerSecond(0.5));
  EXPECT_GT(state.metre_wh, 1.2 * by_sheet_w / 0.5 / 3600.0);
  EXPECT_GT(state.idle_w, flight.sheet().hotel_w);
}

TEST(EnergyEstimate, LearnsWhatAMetreAndASecondTake) {
  Flight flight;
  flight.Fly(600.0, 50.0, 0.0);
  flight.Fly(3000.0, 60.0, 0.5);
  const EnergyState state = flight.At(0.0);
  EXPECT_NEAR(state.metre_wh, 60.0 / 0.5 / 3600.0, 0.02 * state.metre_wh);
  EXPECT_NEAR(state.idle_w, 50.0, 3.0);
}

TEST(EnergyEstimate, TakesTheWayHomeForAsDearAsTheDearestPieceSoFar) {
  Flight flight;
  for (int lane = 0; lane < 6; ++lane) {
    flight.Fly(200.0, lane % 2 == 0 ? 120.0 : 60.0, 0.5);
  }
  EXPECT_NEAR(flight.At(0.0).metre_wh, 120.0 / 0.5 / 3600.0, 0.001);
}

TEST(EnergyEstimate, LearnsThatTheBatteryIsLargerOrSmallerThanBelieved) {
  Flight sound, aged;
  sound.Fly(3600.0, 200.0, 0.5);
  aged.Fly(3600.0, 150.0, 0.5, 2.0);
  EXPECT_GT(sound.At(0.0).capacity_wh, 0.93 * sound.sheet().capacity_wh);
  EXPECT_LE(sound.At(0.0).capacity_wh, sound.sheet().capacity_wh);
  EXPECT_LT(aged.At(0.0).capacity_wh, 0.65 * aged.sheet().capacity_wh);
}

TEST(EnergyEstimate, CountsTheWayHomeTheAscentAndTheLastFix) {
  Flight flight;
  flight.Fly(600.0, 60.0, 0.5);
  const EnergyState here = flight.At(0.0), far = flight.At(1000.0);
  EXPECT_NEAR(here.home_wh, (3.0 / 0.15 + 300.0) * here.idle_w / 3600.0, 1e-9);
  EXPECT_NEAR(far.home_wh - here.home_wh, 1000.0 * far.metre_wh, 1e-9);
  EXPECT_NEAR(far.spare_wh(), (far.reach_m - 1000.0) * far.metre_wh, 1e-6);
}

TEST(EnergyEstimate, DoesNotBelieveAGaugeThatSticks) {
  Flight flight(0.9);
  flight.Fly(3.0 * 3600.0, 110.0, 0.5, 0.0);  // to a charge of 0.2
  const EnergyState state = flight.At(0.0);
  EXPECT_GT(*state.gauge_excess, 0.5);
  EXPECT_LT(state.charge, 0.45);
  EXPECT_LE(state.capacity_wh, flight.sheet().capacity_wh);
}

TEST(EnergyEstimate, TakesTheChargeAloneWhereNobodySaysVoltageAndCurrent) {
  Flight flight(1.0);
  flight.FlyWithoutVoltage(1000.0, 0.3);
  const EnergyState state = flight.At(0.0);
  EXPECT_NEAR(state.used_wh, 0.3 * state.capacity_wh, 0.5);
  EXPECT_FALSE(state.gauge_excess);
}

/// Draws what the sheets say, in a current that sets to the north.
class FlightInACurrent {
 public:
  void Fly(double seconds, double course) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds)); ++i) {
      now_ += Seconds(1.0);
      NavState nav;
      nav.yaw = course, nav.u = kSpeed.value();
      estimate.Hear(nav, now_);
      const double power_w = power.In(kCurrent, {.course = course, .speed = kSpeed});
      charge_ -= power_w / 3600.0 / sheet.capacity_wh;
      const double volts = sheet.OpenCircuitVolts(charge_);
      estimate.Hear({.charge = charge_, .volts = volts, .amperes = power_w / volts}, now_);
    }
  }
  [[nodiscard]] double Home(double course) const {
    return estimate.At({.distance = Meters(100.0), .course = course})->home_wh -
           estimate.At({.distance = Meters(0.0)})->home_wh;
  }

  static constexpr WaterCurrent kCurrent{.north = 0.2, .east = 0.0, .sd = 0.01};
  static constexpr MetersPerSecond kSpeed{0.5};
  BatterySheet sheet;
  WayPower power{VehicleParams{}, sheet};
  EnergyEstimate estimate{VehicleParams{}, sheet};

 private:
  double charge_ = 0.9;
  Seconds now_{100.0};
};

TEST(EnergyEstimate, ForeseesAWayHomeAgainstACurrentThatNoWayMetHeadOn) {
  constexpr double kEast = 0.5 * std::numbers::pi, kSouth = std::numbers::pi;
  FlightInACurrent flight;
  flight.estimate.Hear(FlightInACurrent::kCurrent);
  flight.Fly(3000.0, kEast);
  const double against_w =
      flight.power.In(FlightInACurrent::kCurrent, {.course = kSouth, .speed = flight.kSpeed});
  EXPECT_NEAR(flight.Home(kSouth), against_w * 100.0 / 0.5 / 3600.0, 0.05 * flight.Home(kSouth));
  EXPECT_GT(flight.Home(kSouth), 1.2 * flight.Home(kEast));
}

TEST(EnergyEstimate, DoesNotCountOnBeingCarriedHome) {
  FlightInACurrent flight;
  flight.estimate.Hear(FlightInACurrent::kCurrent);
  flight.Fly(3000.0, std::numbers::pi);
  EXPECT_NEAR(flight.Home(0.0), flight.Home(std::numbers::pi), 0.02 * flight.Home(0.0));
}

TEST(EnergyEstimate, LeavesOutACurrentThatIsNotToldApartFromNone) {
  FlightInACurrent flight;
  EXPECT_TRUE(flight.estimate.CostsByCourse().metres.empty());
  flight.estimate.Hear(WaterCurrent{.north = 0.2, .east = 0.0, .sd = 0.1});
  EXPECT_TRUE(flight.estimate.CostsByCourse().metres.empty());
  flight.estimate.Hear(WaterCurrent{.north = 0.03, .east = 0.0, .sd = 0.001});
  EXPECT_TRUE(flight.estimate.CostsByCourse().metres.empty());
  flight.estimate.Hear(FlightInACurrent::kCurrent);
  EXPECT_FALSE(flight.estimate.CostsByCourse().metres.empty());
}

}  // namespace
}  // namespace limpet
