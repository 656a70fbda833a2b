// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ConstantDepth.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(BhvConstantDepth, RefusesADepthBeyondItsRange) {
  ConfigBlock block{
      .name = "BHV_ConstantDepth", .where = {}, .entries = {{"depth", "7000", {"x.bhv", 4}}}};
  EXPECT_THROW(static_cast<void>(ReadParams<BHV_ConstantDepth::Params>(block)), ConfigError);
}

TEST(BhvConstantDepth, FallsFromItsFlatTopToNothingOverItsBase) {
  BHV_ConstantDepth::Params params;
  params.depth = Meters(5.0);
  params.peakwidth = Meters(0.5);
  params.basewidth = Meters(2.0);
  params.summit_delta = 0.0;
  const Peak peak = *BHV_ConstantDepth(params).Move({}).depth;
  EXPECT_EQ(PeakValue(peak, 5.5 - peak.summit), 1.0);
  EXPECT_NEAR(PeakValue(peak, 6.5 - peak.summit), 0.5, 1e-12);
  EXPECT_NEAR(PeakValue(peak, 2.5 - peak.summit), 0.0, 1e-12);
}

TEST(BhvConstantDepth, DivesToItsDepthAndSaysHowFarOffItIs) {
  HelmFlight flight(
      BehaviorBlock("BHV_ConstantDepth", "  depth = 12\n  depth_mismatch_var = OFF\n"));
  flight.Tick();
  EXPECT_EQ(flight.Last("OFF"), "12");
  flight.Fly(45.0);
  EXPECT_NEAR(flight.depth(), 12.0, 1e-6);
}

TEST(ConstantBehaviors, SayHowFarOffTheVehicleIsAlsoWhileTheyAreIdle) {
  for (const auto& [type, key] : {std::pair{"BHV_ConstantDepth", "depth"},
                                  {"BHV_ConstantSpeed", "speed"},
                                  {"BHV_ConstantHeading", "heading"}}) {
    HelmFlight flight(BehaviorBlock(type, std::string("  condition = GO = true\n  ") + key +
                                              " = 20\n  " + key + "_mismatch_var = OFF\n"));
    flight.Tick();
    const std::string before = flight.Last("OFF");
    EXPECT_NE(before, "") << type;
    flight.PlaceAt(0.0, 0.0, 50.0);
    flight.state().nav.down = 9.0;
    flight.state().nav.u = 1.0;
    flight.Tick();
    EXPECT_NE(flight.Last("OFF"), before) << type << ": a mode may hang on it";
  }
}

TEST(BhvConstantDepth, TakesADepthAboveTheSurfaceForTheSurface) {
  HelmFlight flight(
      BehaviorBlock("BHV_ConstantDepth", "  depth = -3\n  depth_mismatch_var = OFF\n"));
  flight.Tick();
  EXPECT_EQ(flight.Last("OFF"), "0");
}

TEST(BhvConstantDepth, HasNoLimitWithoutADurationAndSaysThatStockHelmsWouldEndItUnlessToldSo) {
  HelmFlight flight(BehaviorBlock("BHV_ConstantDepth", "  depth = 12\n"));
  flight.Fly(30.0);
  EXPECT_EQ(flight.decision().depth, 12.0);
  EXPECT_THAT(flight.Posts("BHV_WARNING"), SizeIs(1));
  EXPECT_THAT(flight.Last("BHV_WARNING"), ::testing::HasSubstr("BHV_ConstantDepth: duration"));
  EXPECT_THAT(flight.host().IgnoredLines(), SizeIs(1)) << "a note of limpet check";
  for (const char* lines :
       {"  depth = 12\n  duration = no-time-limit\n", "  depth = 12\n  duration = 100\n"}) {
    HelmFlight silent(BehaviorBlock("BHV_ConstantDepth", lines));
    silent.Fly(1.0);
    EXPECT_THAT(silent.Posts("BHV_WARNING"), IsEmpty());
    EXPECT_THAT(silent.host().IgnoredLines(), IsEmpty());
  }
}

TEST(BhvConstantDepth, PrefersDepthsAsStockHelmsDo) {
  HelmFlight flight(BehaviorBlock("BHV_ConstantDepth", "  depth = 30\n") +
                    BehaviorBlock("BHV_MaxDepth", "  max_depth = 20\n  basewidth = 0\n"));
  flight.Tick();
  EXPECT_NEAR(flight.decision().depth.value_or(-1.0), 20.0, 0.01) << "of one weight with a limit";
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvConstantDepth, EveryBehavior, BHV_ConstantDepth);

}  // namespace
}  // namespace limpet
