// SPDX-License-Identifier: MIT
#include "limpet/app/embedded.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/registry.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Topic<double> kPing{"TEST_PING", "counts ticks"};
const Topic<double> kPong{"TEST_PONG", "answers each ping"};

class PingApp final : public App {
 public:
  struct Params {
    double step = 1.0;
    template <class V>
    void Describe(V& visit) {
      visit("step", step, "Added per tick", InRange(0.0, 10.0));
    }
  };
  PingApp(const AppContext& context, const Params& params)
      : App(context), params_(params), random_(MakeRandom("noise")) {}
  void Tick(Seconds) override {
    Publish(kPing, count_ += params_.step + 1e-3 * random_.Uniform(0.0, 1.0));
  }
  void Finish(Seconds) override { PublishRaw("TEST_FINISHED", std::string("ping")); }

 private:
  Params params_;
  Random random_;
  double count_ = 0.0;
};

class PongApp final : public App {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  PongApp(const AppContext& context, const Params&) : App(context) {
    Subscribe(kPing, &PongApp::OnPing);
  }

 private:
  void OnPing(const Stamped<double>& ping) { Publish(kPong, ping.value); }
};

LIMPET_REGISTER_APP(PingApp, "pTestPing", 10.0);
LIMPET_REGISTER_APP(PongApp, "pTestPong", 4.0);

EmbeddedSetup TestSetup(std::uint64_t seed = 1) {
  EmbeddedSetup setup;
  setup.community = "alpha";
  setup.apps = {"pTestPing", "pTestPong"};
  setup.session = "discovery";
  setup.seed = seed;
  return setup;
}

/// `TIME NAME=VALUE` of every write of ten seconds.
std::vector<std::string> Trace(EmbeddedSetup setup) {
  EmbeddedCommunity community(std::move(setup));
  std::vector<std::string> trace;
  community.Observe([&trace](const Message& message) {
    const auto* number = std::get_if<double>(&message.value);
    trace.push_back(TextOf(message.time.value()) + " " + message.name + "=" +
                    (number != nullptr ? TextOf(*number) : "text"));
  });
  while (community.elapsed() < Seconds(10.0)) {
    community.Step();
  }
  community.Finish();
  return trace;
}

TEST(EmbeddedCommunity, GivesTheSameBitsForTheSameSeed) {
  EXPECT_EQ(Trace(TestSetup(1)), Trace(TestSetup(1)));
  EXPECT_NE(Trace(TestSetup(1)), Trace(TestSetup(2)));
}

TEST(EmbeddedCommunity, DeliversMailAtTheInstantItIsWritten) {
  EmbeddedCommunity community(TestSetup());
  community.Step();
  const MessagePtr ping = community.database().Latest("TEST_PING");
  const MessagePtr pong = community.database().Latest("TEST_PONG");
  ASSERT_TRUE(ping != nullptr && pong != nullptr);
  EXPECT_EQ(ping->time, pong->time);
  EXPECT_EQ(ping->value, pong->value);
  EXPECT_EQ(pong->source, "pTestPong");
  EXPECT_EQ(pong->community, "alpha");
}

TEST(EmbeddedCommunity, StartsInTheFirstSecondOf2026) {
  EmbeddedCommunity community(TestSetup());
  community.Step();
  EXPECT_EQ(community.now(), Seconds(1767225600.1));
}

TEST(EmbeddedCommunity, TicksAtTheRateOfTheBlock) {
  EmbeddedSetup setup = TestSetup();
  setup.blocks = {{.name = "PTESTPING", .where = {}, .entries = {{"AppTick", "2", {}}}}};
  const auto trace = Trace(std::move(setup));
  EXPECT_EQ(std::ranges::count_if(trace,
                                  [](const std::string& line) {
                                    return line.find("TEST_PING") != std::string::npos;
                                  }),
            20);
}

TEST(EmbeddedCommunity, WithholdsWhatAnAppMayNotHear) {
  EmbeddedSetup setup = TestSetup();
  setup.may_hear = [](const std::string& app, const std::string& variable) {
    return app != "pTestPong" || variable != "TEST_PING";
  };
  EmbeddedCommunity community(std::move(setup));
  community.Step();
  EXPECT_EQ(community.database().Latest("TEST_PONG"), nullptr);
}

TEST(EmbeddedCommunity, AnAppThatHangsNeitherTicksNorHearsUntilItGoesOn) {
  EmbeddedCommunity community(TestSetup());
  int pings = 0, pongs = 0;
  community.Observe([&](const Message& message) {
    pings += message.name == "TEST_PING" ? 1 : 0;
    pongs += message.name == "TEST_PONG" ? 1 : 0;
  });
  const auto run_to = [&community](double seconds) {
    while (community.elapsed() < Seconds(seconds))
      community.Step();
  };
  run_to(1.0);
  community.Stall("pTestPing");
  const int before = pings;
  run_to(2.0);
  EXPECT_EQ(pings, before);
  EXPECT_GE(community.elapsed(), Seconds(2.0)) << "time goes on for the others";
  community.Stall("pTestPing", false);
  community.Stall("pTestPong");
  const int answered = pongs;
  run_to(3.0);
  EXPECT_GT(pings, before);
  EXPECT_EQ(pongs, answered);
  community.Stall("pTestPong", false);
  run_to(3.2);
  EXPECT_GE(pongs, answered + 10) << "the mail has waited";
}

TEST(EmbeddedCommunity, LetsEveryAppFinishAndReportForTheLog) {
  std::vector<std::string> trace = Trace(TestSetup());
  ASSERT_GT(trace.size(), 3U);
  trace.erase(trace.begin(), trace.end() - 3);
  EXPECT_THAT(trace,
              ElementsAre(HasSubstr("TEST_FINISHED"), HasSubstr("APPCAST"), HasSubstr("APPCAST")));
}

TEST(EmbeddedCommunity, ReportsTheProblemsOfAllApps) {
  EmbeddedSetup setup = TestSetup();
  setup.apps = {"pTestPing", "pTestPonk"};
  setup.blocks = {{.name = "pTestPing", .where = {}, .entries = {{"step", "11", {"m.moos", 3}}}}};
  try {
    const EmbeddedCommunity community(std::move(setup));
    FAIL() << "must not build";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("m.moos:3: step: `11` is not allowed"));
    EXPECT_THAT(error.what(), HasSubstr("no app `pTestPonk`; nearest known: `pTestPong`"));
  }
}

}  // namespace
}  // namespace limpet
