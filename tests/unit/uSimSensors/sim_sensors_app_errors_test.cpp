// SPDX-License-Identifier: MIT
// What a scenario says of the sensors' errors, as uSimSensors publishes it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "apps/uSimSensors/sim_sensors_app.hpp"
#include "limpet/topics/sensors.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using Edit = std::function<void(SimulatedErrors&)>;

/// What the sensors said, with their stamps, of `seconds` of a vehicle that goes as `truth` says.
class Flight {
 public:
  explicit Flight(const SimTruth& truth, const Edit& edit = {}, double seconds = 20.0,
                  const Scenario& base = {}) {
    Scenario scenario = base;
    if (edit) edit(scenario.errors);
    AppContext context;
    context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
    context.name = "uSimSensors";
    context.link = &link_;
    context.seed = 5;
    SimSensorsApp app(context, scenario);
    for (int i = 0; i < static_cast<int>(std::lround(50.0 * seconds)); ++i) {
      link_.time = Seconds(1000.0 + 0.02 * i);
      link_.Send(app, topics::kSimTruth, truth);
    }
  }
  template <class T>
  [[nodiscard]] std::vector<Stamped<T>> Of(const Topic<T>& topic) const {
    std::vector<Stamped<T>> samples;
    for (const MessagePtr& message : link_.published) {
      if (message->name != topic.name) continue;
      samples.push_back({message->time, *TopicCodec<T>::Decode(message->value)});
    }
    return samples;
  }

 private:
  TestLink link_;
};

SimTruth Cruising() {
  SimTruth truth;
  truth.down = 3.5;
  truth.u = 0.5;
  truth.r = 0.2;
  return truth;
}

/// Means of `b` less those of `a`.
template <class T, class Value>
double Shift(const std::vector<Stamped<T>>& a, const std::vector<Stamped<T>>& b, Value value) {
  const auto mean = [&](const auto& samples) {
    double sum = 0.0;
    for (const auto& sample : samples)
      sum += value(sample.value);
    return sum / static_cast<double>(samples.size());
  };
  return mean(b) - mean(a);
}

TEST(SensorErrors, OffChangesNoBit) {
  const auto plain = Flight(Cruising()).Of(topics::kDvlData);
  const auto off = Flight(Cruising(), [](SimulatedErrors& e) {
                     e.dvl.bursts.most = MetersPerSecond(3.0);
                     e.gps.multipath.jump = Meters(50.0);
                   }).Of(topics::kDvlData);
  ASSERT_EQ(plain.size(), off.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(plain[i].value.u, off[i].value.u);
    EXPECT_EQ(plain[i].time, off[i].time);
  }
}

TEST(SensorErrors, ADvlTurnedInItsBracketMeasuresSwayWhereThereIsNone) {
  SimTruth truth = Cruising();
  truth.r = 0.0;
  const auto plain = Flight(truth).Of(topics::kDvlData);
  const auto turned = Flight(truth, [](SimulatedErrors& e) {
                        e.dvl.mounting.yaw = Radians::FromTextUnit(2.0);
                      }).Of(topics::kDvlData);
  const double sway = Shift(plain, turned, [](const DvlSample& s) { return *s.v; });
  EXPECT_NEAR(sway, -0.5 * std::sin(RadiansFromDegrees(2.0)), 1e-3);
}

TEST(SensorErrors, ADvlOffItsPlaceMeasuresTheTurnThere) {
  const auto plain = Flight(Cruising()).Of(topics::kDvlData);
  const auto off = Flight(Cruising(), [](SimulatedErrors& e) {
                     e.dvl.mounting.off_B = {0.5, 0.0, 0.0};
                   }).Of(topics::kDvlData);
  EXPECT_NEAR(Shift(plain, off, [](const DvlSample& s) { return *s.v; }), 0.2 * 0.5, 1e-3);
}

TEST(SensorErrors, LostBeamsLeaveNoLockWhereTwoAreLeft) {
  const auto lossy =
      Flight(
          Cruising(), [](SimulatedErrors& e) { e.dvl.beams.loss_share = 0.3; }, 200.0)
          .Of(topics::kDvlData);
  int locked = 0, three = 0;
  for (const auto& sample : lossy) {
    const auto beams = sample.value.beams();
    const auto left = std::ranges::count_if(beams, [](const auto& b) { return b.has_value(); });
    if (!sample.value.has_lock) continue;
    ++locked;
    EXPECT_GE(left, 3);
    three += left == 3 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(locked) / static_cast<double>(lossy.size()), 0.652, 0.05);
  EXPECT_GT(three, locked / 2);
}

TEST(SensorErrors, FalseVelocitiesAreSaidAsValid) {
  const auto bursts = Flight(
                          Cruising(),
                          [](SimulatedErrors& e) {
                            e.dvl.bursts = {.per_h = 360.0, .least = MetersPerSecond(0.8)};
                          },
                          100.0)
                          .Of(topics::kDvlData);
  const auto is_false = [](const Stamped<DvlSample>& s) {
    return s.value.has_lock && std::hypot(*s.value.u - 0.5, *s.value.v + 0.04) > 0.5;
  };
  EXPECT_GT(std::ranges::count_if(bursts, is_false), 50);
}

TEST(SensorErrors, ACompassDeviatesAsItsIronSays) {
  SimTruth truth = Cruising();
  const auto edit = [](SimulatedErrors& e) {
    e.imu.compass.constant = Radians::FromTextUnit(3.0);
    e.imu.compass.sine = Radians::FromTextUnit(5.0);
  };
  for (const auto& [yaw_deg, off_deg] : {std::pair(0.0, 3.0), {90.0, 8.0}, {-90.0, -2.0}}) {
    truth.yaw = RadiansFromDegrees(yaw_deg);
    const double shift =
        Shift(Flight(truth).Of(topics::kImuData), Flight(truth, edit).Of(topics::kImuData),
              [](const ImuSample& s) { return s.heading; });
    EXPECT_NEAR(DegreesFromRadians(shift), off_deg, 1e-3) << yaw_deg;
  }
}

TEST(SensorErrors, AGyroOverstatesTurnsAndDriftsAsItWarmsUp) {
  const auto plain = Flight(Cruising(), {}, 60.0).Of(topics::kFogYawRate);
  const auto drifting =
      Flight(
          Cruising(),
          [](SimulatedErrors& e) {
            e.fog.gyro = {
                .scale_error = 0.01, .drift_deg_per_h = 3600.0, .drift_time = Seconds(10.0)};
          },
          60.0)
          .Of(topics::kFogYawRate);
  EXPECT_NEAR(drifting.front().value - plain.front().value, 0.01 * 0.2, 1e-9);
  EXPECT_NEAR(drifting.back().value - plain.back().value, 0.002 + RadiansFromDegrees(1.0), 1e-4);
}

TEST(SensorErrors, DepthIsOffByTheAirPressureAndItsTrend) {
  const auto plain = Flight(Cruising()).Of(topics::kDepthSensor);
  const auto off = Flight(Cruising(), [](SimulatedErrors& e) {
                     e.depth.pressure = {.offset = Meters(0.4), .trend_m_per_h = 3.6};
                   }).Of(topics::kDepthSensor);
  EXPECT_NEAR(off.front().value - plain.front().value, 0.4, 1e-9);
  EXPECT_NEAR(off.back().value - plain.back().value, 0.42, 1e-3);
}

TEST(SensorErrors, FixesJumpAndSayTheUsualAccuracy) {
  SimTruth afloat;
  afloat.down = 0.13;
  const auto fixes = Flight(
                         afloat,
                         [](SimulatedErrors& e) {
                           e.gps.multipath = {.jumps_per_h = 360.0, .jump = Meters(50.0)};
                         },
                         300.0)
                         .Of(topics::kGpsData);
  const auto far = std::ranges::count_if(
      fixes, [](const auto& f) { return std::hypot(f.value.north, f.value.east) > 10.0; });
  EXPECT_GT(far, 30);
  EXPECT_LT(far, 270);
  for (const auto& fix : fixes)
    EXPECT_EQ(fix.value.sd, fixes.front().value.sd);
}

TEST(SensorErrors, ALateStampComesNoSoonerThanItSays) {
  const auto plain = Flight(Cruising()).Of(topics::kDepthSensor);
  const auto late = Flight(Cruising(), [](SimulatedErrors& e) {
                      e.depth.stamps = {.delay = Seconds(0.3)};
                    }).Of(topics::kDepthSensor);
  ASSERT_EQ(late.size(), plain.size() - 6);
  for (std::size_t i = 0; i < late.size(); ++i) {
    EXPECT_EQ(late[i].value, plain[i].value);
    EXPECT_NEAR((late[i].time - plain[i].time).value(), 0.3, 1e-6);
  }
}

}  // namespace
}  // namespace limpet
