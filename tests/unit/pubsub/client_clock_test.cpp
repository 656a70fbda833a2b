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

TEST(ClientClock, FollowsABrokerOnAnotherMachine) {
  ClientClock clock(1.0);
  clock.TakeWelcome(WelcomeFrom("hostname=elsewhere", clock.Own().value() + kAhead), false);
  EXPECT_NEAR(Ahead(clock), kAhead, 1e-6);
  const double now = clock.Own().value();
  clock.TakeEcho({.time = now, .number = now + kAhead + 1.0});
  EXPECT_NEAR(Ahead(clock), kAhead + 0.1, 0.01) << "one echo moves it by a tenth";
}

TEST(ClientClock, BelievesNoEchoThatWaitedForANewConnection) {
  ClientClock clock(1.0);
  clock.TakeWelcome(WelcomeFrom("hostname=elsewhere", clock.Own().value() + kAhead), false);
  const double long_ago = clock.Own().value() - 10.0;
  clock.TakeEcho({.time = long_ago, .number = long_ago + 500.0});
  EXPECT_NEAR(Ahead(clock), kAhead, 1e-6);
}

TEST(ClientClock, LearnsTheWarpFromTheWelcomeIfAsked) {
  const double shown = 10.0 * UnixTime().value();
  ClientClock learns(1.0), keeps(1.0);
  learns.TakeWelcome(WelcomeFrom("hostname=elsewhere", shown), true);
  keeps.TakeWelcome(WelcomeFrom("hostname=elsewhere", shown), false);
  EXPECT_DOUBLE_EQ(learns.warp(), 10.0);
  EXPECT_DOUBLE_EQ(keeps.warp(), 1.0);
}

}  // namespace
}  // namespace limpet
