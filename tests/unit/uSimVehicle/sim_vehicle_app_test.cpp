// SPDX-License-Identifier: MIT
#include "apps/uSimVehicle/sim_vehicle_app.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/topics/safety.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

AppContext ContextFor(TestLink& link, bool runs_live = false) {
  AppContext context;
  context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
  context.runs_live = runs_live;
  context.name = "uSimVehicle";
  context.link = &link;
  return context;
}

Scenario Table() {
  Scenario scenario;
  scenario.start = {.north_m = -12.5, .east_m = -15.5, .heading_deg = 90.0};
  return scenario;
}

SimVehicleApp::Params ParamsFor(const std::string& integrator) {
  SimVehicleApp::Params params;
  params.integrator = integrator;
  return params;
}

class SimVehicle {
 public:
  explicit SimVehicle(const Scenario& scenario, const std::string& integrator = "cvode",
                      bool runs_live = false)
      : app_(ContextFor(link_, runs_live), ParamsFor(integrator), scenario) {}
  /// A pilot that says its command ten times a second.
  void Run(const ThrusterCommand& command, double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(50.0 * seconds)); ++i) {
      if (i % 5 == 0) link_.Send(app_, topics::kThrusterCommand, command);
      TickOn();
    }
  }
  void RunSilently(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(50.0 * seconds)); ++i)
      TickOn();
  }
  void Say(const std::string& command) {
    app_.Deliver(std::make_shared<const Message>(Message{.name = "THRUSTER_COMMAND",
                                                         .value = command,
                                                         .time = link_.time,
                                                         .source = "uPoke",
                                                         .source_aux = "",
                                                         .community = ""}));
  }
  [[nodiscard]] Seconds now() const { return link_.time; }
  [[nodiscard]] SimThrust Thrust() const { return *link_.Last(topics::kSimThrust); }
  void Wait(double seconds) { link_.time += Seconds(seconds); }
  [[nodiscard]] std::vector<double> TimesOfTruths() const {
    std::vector<double> times;
    for (const MessagePtr& message : link_.published) {
      if (message->name == topics::kSimTruth.name) times.push_back(message->time.value());
    }
    return times;
  }
  [[nodiscard]] std::optional<BatteryState> Battery() const { return link_.Last(topics::kBattery); }
  [[nodiscard]] SimTruth Truth() const { return *link_.Last(topics::kSimTruth); }
  [[nodiscard]] std::vector<std::string> Events() const {
    std::vector<std::string> events;
    for (const MessagePtr& message : link_.published) {
      if (message->name == topics::kSimEvent.name) {
        events.push_back(std::get<std::string>(message->value));
      }
    }
    return events;
  }
  [[nodiscard]] std::vector<double> TimesOfBeats() const {
    std::vector<double> times;
    for (const MessagePtr& message : link_.published) {
      if (message->name == topics::kShoreBeat.name) times.push_back(message->time.value());
    }
    return times;
  }
  [[nodiscard]] std::size_t CountOfTruths() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        link_.published, [](const auto& m) { return m->name == topics::kSimTruth.name; }));
  }
  [[nodiscard]] const App& app() const { return app_; }

 private:
  void TickOn() {
    app_.Tick(link_.time);
    link_.time += Seconds(0.02);
  }
  TestLink link_;
  SimVehicleApp app_;
};

constexpr ThrusterCommand kDown{.t5 = 0.6, .t6 = 0.6};

TEST(SimVehicleApp, StartsAfloatAtTheScenariosStart) {
  SimVehicle vehicle(Table());
  vehicle.Run({}, 1.0);
  const SimTruth truth = vehicle.Truth();
  EXPECT_NEAR(truth.north, -12.5, 1e-6);
  EXPECT_NEAR(truth.east, -15.5, 1e-6);
  EXPECT_NEAR(truth.yaw, M_PI / 2.0, 1e-9);
  EXPECT_LT(truth.down, 0.2);
}

TEST(SimVehicleApp, PublishesTheTruthAtEveryTick) {
  SimVehicle vehicle(Table());
  vehicle.Run({}, 2.0);
  EXPECT_EQ(vehicle.CountOfTruths(), 100U);
}

TEST(SimVehicleApp, ALateTickMakesUpForTheTruthsThatSensorsHaveMissed) {
  SimVehicle steady(Table(), "cvode", true), halting(Table(), "cvode", true);
  steady.Run(kDown, 2.0);
  halting.Run(kDown, 1.0);
  halting.Wait(0.5);
  halting.Run(kDown, 0.5);
  EXPECT_NEAR(halting.Truth().down, steady.Truth().down, 1e-6);
  const std::vector<double> times = halting.TimesOfTruths();
  for (std::size_t i = 1; i < times.size(); ++i) {
    EXPECT_GT(times[i] - times[i - 1], 0.015);
    EXPECT_LT(times[i] - times[i - 1], 0.035);
  }
}

TEST(SimVehicleApp, TellsOfSubmergingAndOfTheBottom) {
  SimVehicle vehicle(Table());
  vehicle.Run(kDown, 60.0);
  EXPECT_EQ(vehicle.Events(), (std::vector<std::string>{"submerged", "touched_bottom"}));
  EXPECT_TRUE(vehicle.app().warnings().empty());
}

TEST(SimVehicleApp, StopsItsThrustersAndFloatsUpWhenThePilotFallsSilent) {
  SimVehicle vehicle(Table());
  vehicle.Run(kDown, 12.0);
  const double deep = vehicle.Truth().down;
  ASSERT_GT(deep, 1.0);
  const Seconds silent = vehicle.now();
  vehicle.RunSilently(1.2);
  EXPECT_EQ(vehicle.Thrust().greatest, 0.0);
  ASSERT_TRUE(vehicle.Thrust().zero_at.has_value());
  EXPECT_LT(*vehicle.Thrust().zero_at - silent.value(), 1.05);
  EXPECT_LE(vehicle.Thrust().oldest_obeyed, 1.0);
  EXPECT_EQ(vehicle.Thrust().stops, 1);
  EXPECT_TRUE(vehicle.app().warnings().contains("COMMAND_STALE"));
  vehicle.RunSilently(120.0);
  EXPECT_LT(vehicle.Truth().down, 0.2) << "it is buoyant";
  vehicle.Run(kDown, 0.5);
  EXPECT_TRUE(vehicle.app().warnings().empty());
}

TEST(SimVehicleApp, ALateTickStopsTheThrustersInTheMidstOfWhatItMakesUpFor) {
  SimVehicle vehicle(Table(), "cvode", true);
  vehicle.Run(kDown, 1.0);
  const Seconds silent = vehicle.now();
  vehicle.Wait(1.4);  // the machine had no time for it, and no command came meanwhile
  vehicle.RunSilently(0.02);
  EXPECT_LT(*vehicle.Thrust().zero_at - silent.value(), 1.05);
}

TEST(SimVehicleApp, ObeysNoCommandThatIsNotFiniteOrBeyondFullThrust) {
  SimVehicle vehicle(Table());
  vehicle.Run({}, 0.2);
  const std::vector<std::pair<const char*, const char*>> refused{
      {"t1=nan,t2=0,t3=0,t4=0,t5=0,t6=0", "BAD_MAIL_THRUSTER_COMMAND"},
      {"t1=0,t2=inf,t3=0,t4=0,t5=0,t6=0", "BAD_MAIL_THRUSTER_COMMAND"},
      {"t1=0,t2=0,t3=0,t4=0,t5=1e9,t6=0", "COMMAND_REFUSED"},
      {"t1=0,t2=0,t3=0,t4=0,t5=0,t6=-1.5", "COMMAND_REFUSED"},
      {"t1=0,t2=0,t3=0,t4=0,t5=0,t6=0,t7=0.5", "COMMAND_REFUSED"}};
  for (const auto& [bad, warning] : refused) {
    vehicle.Say(bad);
    vehicle.RunSilently(0.5);
    EXPECT_EQ(vehicle.Thrust().greatest, 0.0) << bad;
    EXPECT_TRUE(vehicle.app().warnings().contains(warning)) << bad;
  }
  EXPECT_FALSE(std::isnan(vehicle.Truth().down));
  vehicle.RunSilently(1.0);
  EXPECT_GE(vehicle.Thrust().refused, 2);
  vehicle.Run({}, 0.2);
  EXPECT_FALSE(vehicle.app().warnings().contains("COMMAND_REFUSED"));
}

TEST(SimVehicleApp, DriftsWithTheScenariosCurrent) {
  Scenario scenario = Table();
  scenario.water.current_east_mps = 0.1;
  SimVehicle vehicle(scenario);
  vehicle.Run({}, 10.02);
  EXPECT_NEAR(vehicle.Truth().east, -15.5 + 1.0, 1e-3);
}

TEST(SimVehicleApp, DriftsWithATideThatTurnsBack) {
  Scenario scenario = Table();
  scenario.water.current_east_mps = 0.1;
  scenario.water.current.tide_period = Seconds(40.0);
  scenario.water.current.tide_share = 2.0;
  for (const std::string integrator : {"cvode", "rk4"}) {
    SimVehicle vehicle(scenario, integrator);
    double least = 0.0, most = 0.0;
    for (int second = 0; second < 40; ++second) {
      const double before = vehicle.Truth().east;
      vehicle.Run({}, 1.0);
      if (second == 0) continue;
      least = std::min(least, vehicle.Truth().east - before);
      most = std::max(most, vehicle.Truth().east - before);
    }
    EXPECT_NEAR(most, 0.3, 0.01) << integrator;
    EXPECT_NEAR(least, -0.1, 0.01) << integrator;
    EXPECT_NEAR(vehicle.Truth().east, -15.5 + 4.0, 0.02) << integrator;
  }
}

TEST(SimVehicleApp, ACurrentWeakensWithDepth) {
  Scenario scenario = Table();
  scenario.water.current_east_mps = 0.1;
  scenario.water.current.shear_per_m = 1.0;
  SimVehicle vehicle(scenario);
  vehicle.Run({}, 10.02);  // floats 0.13 m deep
  EXPECT_NEAR(vehicle.Truth().east, -15.5 + 0.87, 0.01);
}

TEST(SimVehicleApp, FouledThrustersPushLess) {
  const ThrusterCommand ahead{.t1 = 0.8, .t2 = 0.8, .t3 = 0.8, .t4 = 0.8, .t5 = 0.0, .t6 = 0.0};
  const auto speed_with = [&ahead](const ThrusterErrorParams& error) {
    Scenario scenario = Table();
    scenario.errors.thrusters = error;
    SimVehicle vehicle(scenario);
    vehicle.Run(ahead, 20.0);
    return vehicle.Truth().u;
  };
  const double full = speed_with({});
  EXPECT_NEAR(speed_with({.thrust_factor = 0.5}) / full, std::sqrt(0.5), 0.05);
  EXPECT_NEAR(speed_with({.saturates_at = 0.4}) / full, std::sqrt(0.5), 0.05);
  EXPECT_NEAR(speed_with({.lag_factor = 5.0}) / full, 1.0, 0.03);
}

TEST(SimVehicleApp, FliesTheSameTrackWithEitherIntegrator) {
  SimVehicle cvode(Table(), "cvode");
  SimVehicle rk4(Table(), "rk4");
  const ThrusterCommand forward{.t1 = 0.3, .t2 = 0.35, .t3 = 0.3, .t4 = 0.35, .t5 = 0.2, .t6 = 0.2};
  cvode.Run(forward, 30.0);
  rk4.Run(forward, 30.0);
  EXPECT_NEAR(cvode.Truth().north, rk4.Truth().north, 1e-4);
  EXPECT_NEAR(cvode.Truth().east, rk4.Truth().east, 1e-4);
}

TEST(SimVehicleRestart, ResumesWhereItsFormerLifeLeftTheVehicle) {
  TestLink link;
  AppContext context = ContextFor(link);
  context.is_restarted = true;
  SimVehicleApp app(context, {}, Table());
  app.Tick(link.time);
  EXPECT_FALSE(link.Last(topics::kSimTruth).has_value()) << "it must not jump to the start";
  link.Send(app, topics::kSimTruth, SimTruth{.north = 3.0, .east = 4.0, .down = 2.5, .yaw = 1.0});
  link.time += Seconds(0.02);
  app.Tick(link.time);
  const auto truth = link.Last(topics::kSimTruth);
  ASSERT_TRUE(truth.has_value());
  EXPECT_NEAR(truth->north, 3.0, 0.01);
  EXPECT_NEAR(truth->east, 4.0, 0.01);
  EXPECT_NEAR(truth->down, 2.5, 0.05);
  EXPECT_NEAR(truth->yaw, 1.0, 0.01);
}

TEST(SimVehicleRestart, GoesOnWithTheChargeOfItsFormerLife) {
  TestLink link;
  AppContext context = ContextFor(link);
  context.is_restarted = true;
  SimVehicleApp app(context, {}, Table());
  link.Send(app, topics::kSimBattery, SimBattery{.charge = 0.4});
  link.Send(app, topics::kSimTruth, SimTruth{.down = 2.5});
  app.Tick(link.time);
  EXPECT_NEAR(link.Last(topics::kSimBattery)->charge, 0.4, 1e-6);
}

TEST(SimVehicleApp, TellsWhatItsBatterySaysOnceASecond) {
  SimVehicle vehicle(Table());
  vehicle.Run(kDown, 5.0);
  ASSERT_TRUE(vehicle.Battery().has_value());
  EXPECT_GT(*vehicle.Battery()->amperes, 2.0);
  EXPECT_NEAR(vehicle.Battery()->charge, 1.0, 0.1);
}

TEST(SimVehicleApp, RisesWithoutThrustWhenItsBatteryHasSwitchedOff) {
  Scenario scenario = Table();
  scenario.errors.battery.charge = 0.1;
  scenario.errors.battery.capacity_factor = 0.01;
  SimVehicle vehicle(scenario, "rk4");
  vehicle.Run(kDown, 6.0);
  const double down = vehicle.Truth().down;
  EXPECT_GT(down, 0.5);
  vehicle.Run(kDown, 60.0);
  EXPECT_LT(vehicle.Truth().down, down);
  EXPECT_EQ(vehicle.Battery()->amperes, 0.0);
  EXPECT_TRUE(vehicle.app().warnings().contains("BATTERY_OFF"));
}

TEST(SimVehicleRestart, StartsAnewWhenNobodyKnowsItsPlace) {
  TestLink link;
  AppContext context = ContextFor(link);
  context.is_restarted = true;
  SimVehicleApp app(context, {}, Table());
  for (int i = 0; i < 150; ++i) {
    app.Tick(link.time);
    link.time += Seconds(0.02);
  }
  ASSERT_TRUE(link.Last(topics::kSimTruth).has_value());
  EXPECT_NEAR(link.Last(topics::kSimTruth)->north, -12.5, 0.01);
}

TEST(SimVehicleApp, TheLinkToTheShoreIsLostAndComesBack) {
  Scenario scenario = Table();
  scenario.faults = {
      {.what = "link_lost", .when = "", .at = Seconds(5.0), .lasts = Seconds(10.0), .app = ""}};
  SimVehicle vehicle(scenario);
  const double start = vehicle.now().value();
  vehicle.Run({}, 20.0);
  const std::vector<double> beats = vehicle.TimesOfBeats();
  ASSERT_GE(beats.size(), 8U);
  double longest = 0.0;
  for (std::size_t i = 1; i < beats.size(); ++i) {
    const double gap = beats[i] - beats[i - 1];
    if (gap > 1.05) {
      EXPECT_NEAR(beats[i - 1] - start, 5.0, 1.05);
    }
    longest = std::max(longest, gap);
  }
  EXPECT_NEAR(longest, 11.0, 1.0);
}

TEST(SimVehicleApp, WithoutSuchAFaultNoShoreIsMadeUp) {
  SimVehicle vehicle(Table());
  vehicle.Run({}, 5.0);
  EXPECT_TRUE(vehicle.TimesOfBeats().empty());
}

TEST(SimVehicleApp, ACurrentSetsInGraduallyAndCarriesTheVehicleAway) {
  Scenario scenario = Table();
  scenario.faults = {{.what = "current",
                      .when = "",
                      .at = Seconds(1.0),
                      .lasts = Seconds(20.0),
                      .size = 1.0,
                      .app = ""}};
  SimVehicle vehicle(scenario), calm(Table());
  vehicle.Run({}, 20.0);
  calm.Run({}, 20.0);
  // 0.2 m/s more each second up to 1 m/s: 2.5 m in five seconds, then 14 m in as many more.
  EXPECT_NEAR(vehicle.Truth().north - calm.Truth().north, 16.5, 0.5);
  EXPECT_NEAR(vehicle.Truth().east, calm.Truth().east, 0.1);
  const double swept = vehicle.Truth().north - calm.Truth().north;
  vehicle.Run({}, 20.0);
  calm.Run({}, 20.0);
  EXPECT_NEAR(vehicle.Truth().north - calm.Truth().north - swept, 3.5, 0.5) << "it ceases likewise";
}

TEST(SimVehicleApp, SaysInACommunityWhichFaultsNobodyMakesThere) {
  Scenario scenario = Table();
  scenario.faults = {{.what = "leak", .when = "", .at = {}, .lasts = {}, .app = ""}};
  EXPECT_FALSE(SimVehicle(scenario, "rk4", true).app().warnings().contains("FAULT_NOT_MADE"));
  scenario.faults.push_back(
      {.what = "app_hangs", .when = "", .at = {}, .lasts = {}, .app = "pNav"});
  EXPECT_TRUE(SimVehicle(scenario, "rk4", true).app().warnings().contains("FAULT_NOT_MADE"));
  EXPECT_FALSE(SimVehicle(scenario, "rk4", false).app().warnings().contains("FAULT_NOT_MADE"));
}

}  // namespace
}  // namespace limpet
