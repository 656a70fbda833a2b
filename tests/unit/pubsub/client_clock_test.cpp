// SPDX-License-Identifier: MIT
#include "limpet/pubsub/client_clock.hpp"

#include <gtest/gtest.h>

#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

constexpr double kAhead = 25.0;  // [s] of the broker's clock

WireMessage WelcomeFrom(const std::string& host, double time) {
  return {.type = wire_type::kWelcome,
          .data_type = wire_data::kDouble,
          .source_aux = host,
          .time = time,
          .number = kAhead};
}

double Ahead(const ClientClock& clock) { return (clock.Now() - clock.Own()).value(); }

/// Time goes on between the readings of a test, by no more than what has passed since `start`.
void ExpectAhead(const ClientClock& clock, double ahead, double start) {
  const double shown = Ahead(clock);
  EXPECT_NEAR(shown, ahead, clock.Own().value() - start + 1e-6);
}

TEST(ClientClock, FollowsABrokerOnAnotherMachine) {
  ClientClock clock(1.0);
  const double start = clock.Own().value();
  clock.TakeWelcome(WelcomeFrom("hostname=elsewhere", start + kAhead), false);
  ExpectAhead(clock, kAhead, start);
  const double now = clock.Own().value();
  clock.TakeEcho({.time = now, .number = now + kAhead + 1.0});
  EXPECT_NEAR(Ahead(clock), kAhead + 0.1, 0.01) << "one echo moves it by a tenth";
}

TEST(ClientClock, BelievesNoEchoThatWaitedForANewConnection) {
  ClientClock clock(1.0);
  const double start = clock.Own().value();
  clock.TakeWelcome(WelcomeFrom("hostname=elsewhere", start + kAhead), false);
  const double long_ago = start - 10.0;
  clock.TakeEcho({.time = long_ago, .number = long_ago + 500.0});
  ExpectAhead(clock, kAhead, start);
}

TEST(ClientClock, LearnsTheWarpFromTheWelcomeIfAsked) {
  const double shown = 10.0 * UnixTime().value();
  ClientClock learns(1.0), keeps(1.0);
  learns.TakeWelcome(WelcomeFrom("hostname=elsewhere", shown), true);
  keeps.TakeWelcome(WelcomeFrom("hostname=elsewhere", shown), false);
  EXPECT_DOUBLE_EQ(learns.warp(), 10.0);
  EXPECT_DOUBLE_EQ(keeps.warp(), 1.0);
}

/// A broker of ours on this machine, whose vehicle time is `ahead` of this process's.
WireMessage WelcomeHere(double ahead, std::string& words) {
  words = "hostname=" + HostWords("vm");
  const std::string own = TextOf(OwnClockOrigin());
  const auto at = words.find(own);
  const auto ns = static_cast<std::int64_t>(1e9 * ahead);
  words.replace(at, own.size(), TextOf(ClockOrigin{OwnClockOrigin().ns + ns}));
  return WelcomeFrom(words, VehicleTime().value() + ahead);
}

TEST(ClientClock, AgreesExactlyWithABrokerOfItsMachineThatWasStartedByAnotherDate) {
  std::string words;
  ClientClock clock(1.0);
  const double start = clock.Own().value();
  clock.TakeWelcome(WelcomeHere(-3600.0, words), false);
  ExpectAhead(clock, -3600.0, start);
  const double now = clock.Own().value();
  clock.TakeEcho({.time = now, .number = now - 3600.2});  // that echo was long on its way
  ExpectAhead(clock, -3600.0, start);
}

TEST(ClientClock, StaysWhenItsBrokerComesBackWithAnotherDate) {
  std::string words;
  ClientClock clock(1.0);
  const double start = clock.Own().value();
  clock.TakeWelcome(WelcomeHere(0.0, words), false);
  clock.TakeWelcome(WelcomeHere(3600.0, words), false);
  ExpectAhead(clock, 0.0, start);
  const double now = clock.Own().value();
  clock.TakeEcho({.time = now, .number = now + 3600.0});
  EXPECT_NEAR(clock.disagreement().value(), 3600.0, 0.1);
}

TEST(ClientClock, FollowsAStrangersStepSlowlyAndNeverBackwards) {
  ClientClock clock(1.0);
  clock.TakeWelcome(WelcomeFrom("hostname=elsewhere", clock.Own().value() + kAhead), false);
  const Seconds before = clock.Now();
  const double own = clock.Own().value();
  clock.TakeEcho({.time = own, .number = own + kAhead - 10.0});
  EXPECT_GE(clock.Now(), before);
  EXPECT_NEAR(clock.disagreement().value(), -9.9, 0.05);
}

TEST(ClientClock, AStockClientDoesNotTakeTheBrokersHostForItsOwn) {
  EXPECT_NE(HostWords("vm").substr(0, HostWords("vm").find(',')), "vm");
}

}  // namespace
}  // namespace limpet
