// SPDX-License-Identifier: MIT
#include "apps/uSimSensors/sim_sensors_app.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limpet/topics/sensors.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

AppContext ContextFor(TestLink& link, std::uint64_t seed = 1) {
  AppContext context;
  context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
  context.name = "uSimSensors";
  context.link = &link;
  context.seed = seed;
  return context;
}

struct Outbox {
  std::vector<MessagePtr> mail;
  [[nodiscard]] std::ptrdiff_t Count(const std::string& name) const {
    return std::ranges::count_if(mail, [&name](const auto& m) { return m->name == name; });
  }
};

Outbox TenSeconds(double down, std::uint64_t seed) {
  TestLink link;
  SimSensorsApp app(ContextFor(link, seed), Scenario{});
  for (int i = 0; i < 500; ++i) {
    SimTruth truth;
    truth.down = down;
    link.Send(app, topics::kSimTruth, truth);
    link.time += Seconds(0.02);
  }
  return {std::move(link.published)};
}

TEST(SimSensorsApp, PublishesEachSensorAtItsRate) {
  const Outbox run = TenSeconds(3.5, 1);
  EXPECT_EQ(run.Count("IMU_DATA"), 500);
  EXPECT_EQ(run.Count("FOG_YAW_RATE"), 500);
  EXPECT_EQ(run.Count("DEPTH_SENSOR"), 200);
  EXPECT_EQ(run.Count("DVL_DATA"), 50);
}

TEST(SimSensorsApp, AMeasurementHasTheTimeOfWhatItMeasured) {
  TestLink link;
  SimSensorsApp app(ContextFor(link), Scenario{});
  const auto truth =
      std::make_shared<const Message>(Message{.name = topics::kSimTruth.name,
                                              .value = TopicCodec<SimTruth>::Encode({.down = 3.5}),
                                              .time = link.time - Seconds(0.04),
                                              .source = "uSimVehicle",
                                              .source_aux = "",
                                              .community = ""});
  app.Deliver(truth);
  ASSERT_FALSE(link.published.empty());
  for (const MessagePtr& message : link.published)
    EXPECT_EQ(message->time, truth->time) << message->name;
}

TEST(SimSensorsApp, HasGpsAtTheSurfaceOnly) {
  EXPECT_EQ(TenSeconds(3.5, 1).Count("GPS_DATA"), 0);
  EXPECT_EQ(TenSeconds(0.13, 1).Count("GPS_DATA"), 10);
}

TEST(SimSensorsApp, MeasuresNothingFromATruthThatWasHeldUp) {
  TestLink link;
  AppContext context = ContextFor(link);
  context.runs_live = true;
  SimSensorsApp app(context, Scenario{});
  const auto truth = [&link](Seconds age) {
    return std::make_shared<const Message>(
        Message{.name = topics::kSimTruth.name,
                .value = TopicCodec<SimTruth>::Encode(SimTruth{}),
                .time = link.time - age,
                .source = "test",
                .source_aux = "",
                .community = ""});
  };
  app.Deliver(truth(Seconds(3.0)));
  EXPECT_TRUE(link.published.empty());
  app.Deliver(truth(Seconds(0.1)));
  EXPECT_FALSE(link.published.empty());
}

TEST(SimSensorsApp, GivesTheSameBitsForTheSameSeed) {
  const Outbox one = TenSeconds(0.13, 7);
  const Outbox two = TenSeconds(0.13, 7);
  ASSERT_EQ(one.mail.size(), two.mail.size());
  for (std::size_t i = 0; i < one.mail.size(); ++i) {
    ASSERT_EQ(one.mail[i]->value, two.mail[i]->value);
  }
}

TEST(SimSensorsApp, GivesOtherNoiseForAnotherSeed) {
  EXPECT_NE(TenSeconds(3.5, 7).mail.back()->value, TenSeconds(3.5, 8).mail.back()->value);
}

TEST(SimSensorsApp, TellsTheOperatorWhatItSent) {
  TestLink link;
  SimSensorsApp app(ContextFor(link), Scenario{});
  link.Send(app, topics::kSimTruth, SimTruth{});
  ReportLines lines;
  app.Report(lines);
  EXPECT_NE(lines.Text().find("  IMU_DATA               50        1"), std::string::npos)
      << lines.Text();
}

}  // namespace
}  // namespace limpet
