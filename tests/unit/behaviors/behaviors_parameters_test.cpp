// SPDX-License-Identifier: MIT
// What holds for every behavior there is: of its parameters, and of its first tick.
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "behaviors/BHV_AbortToPoint.hpp"
#include "behaviors/BHV_AvoidObstacle.hpp"
#include "behaviors/BHV_ConstantDepth.hpp"
#include "behaviors/BHV_ConstantHeading.hpp"
#include "behaviors/BHV_ConstantSpeed.hpp"
#include "behaviors/BHV_CoverArea.hpp"
#include "behaviors/BHV_FollowPath.hpp"
#include "behaviors/BHV_FullStop.hpp"
#include "behaviors/BHV_GoToDepth.hpp"
#include "behaviors/BHV_HoldAltitude.hpp"
#include "behaviors/BHV_HoldStation.hpp"
#include "behaviors/BHV_LegRun.hpp"
#include "behaviors/BHV_Loiter.hpp"
#include "behaviors/BHV_MaxDepth.hpp"
#include "behaviors/BHV_MinAltitudeX.hpp"
#include "behaviors/BHV_OpRegion.hpp"
#include "behaviors/BHV_OpRegionV24.hpp"
#include "behaviors/BHV_PeriodicSurface.hpp"
#include "behaviors/BHV_ReduceMapEntropy.hpp"
#include "behaviors/BHV_ReduceObjectEntropy.hpp"
#include "behaviors/BHV_ReturnHome.hpp"
#include "behaviors/BHV_RevisitOpi.hpp"
#include "behaviors/BHV_StationKeep.hpp"
#include "behaviors/BHV_TestFailure.hpp"
#include "behaviors/BHV_Timer.hpp"
#include "behaviors/BHV_Waypoint.hpp"
#include "behaviors/BHV_ZigZag.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

ConfigBlock BlockOf(const std::vector<ParamSpec>& specs) {
  ConfigBlock block{.name = "BHV", .where = {"mission.bhv", 3}, .entries = {}};
  for (const ParamSpec& spec : specs) {
    if (spec.is_required) block.entries.push_back({spec.name, spec.example[0], {"mission.bhv", 4}});
    if (!spec.needed_unless.empty()) {
      block.entries.push_back({spec.needed_unless, "ANEW", {"mission.bhv", 5}});
    }
  }
  return block;
}

template <class B>
class EveryBehavior : public ::testing::Test {
 protected:
  [[nodiscard]] static std::string ComplaintAbout(const std::string& key,
                                                  const std::string& value) {
    ConfigBlock block = BlockOf(entry_.describe());
    std::erase_if(block.entries, [&key](const ConfigEntry& e) { return e.key == key; });
    block.entries.push_back({key, value, {"mission.bhv", 17}});
    try {
      static_cast<void>(entry_.create(block));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  static inline const BehaviorEntry entry_ = MakeBehaviorEntry<B>();
};

using Behaviors =
    ::testing::Types<BHV_ConstantDepth, BHV_ConstantHeading, BHV_ConstantSpeed, BHV_Loiter,
                     BHV_StationKeep, BHV_TestFailure, BHV_Timer, BHV_LegRun, BHV_OpRegionV24,
                     BHV_Waypoint, BHV_AvoidObstacle, BHV_ZigZag, BHV_FullStop, BHV_CoverArea,
                     BHV_FollowPath, BHV_HoldAltitude, BHV_HoldStation, BHV_OpRegion,
                     BHV_ReduceMapEntropy, BHV_ReduceObjectEntropy, BHV_ReturnHome, BHV_RevisitOpi,
                     BHV_GoToDepth, BHV_MaxDepth, BHV_MinAltitudeX, BHV_PeriodicSurface>;
TYPED_TEST_SUITE(EveryBehavior, Behaviors);

TYPED_TEST(EveryBehavior, IsBuiltFromItsExamples) {
  const std::vector<ParamSpec> specs = this->entry_.describe();
  ConfigBlock block = BlockOf(specs);
  EXPECT_NO_THROW(static_cast<void>(this->entry_.create(block)));
  block.entries.clear();
  for (const ParamSpec& spec : specs) {
    block.entries.push_back({spec.name, spec.example[0], {"mission.bhv", 4}});
  }
  EXPECT_NO_THROW(static_cast<void>(this->entry_.create(block))) << "its defaults, said aloud";
}

TYPED_TEST(EveryBehavior, RefusesAKeyThatItDoesNotHaveAndNamesTheNearest) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    const std::string misspelt = spec.name + "q";
    const std::string complaint = this->ComplaintAbout(misspelt, spec.example[0]);
    EXPECT_THAT(complaint, HasSubstr("mission.bhv:17: " + misspelt + ": "));
    EXPECT_THAT(complaint, HasSubstr("`" + spec.name + "`"));
  }
  EXPECT_THAT(this->ComplaintAbout("conditon", "A = 1"), HasSubstr("`condition`"));
}

TYPED_TEST(EveryBehavior, RefusesWordsWhereANumberBelongs) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    if (spec.allowed == "text") continue;
    for (const char* value : {"much", "", "1e999", "nan", "3 4"}) {
      const bool is_default = spec.default_text == value && !spec.is_required;
      if (is_default) continue;
      const std::string complaint = this->ComplaintAbout(spec.name, value);
      EXPECT_THAT(complaint, HasSubstr("mission.bhv:17: " + spec.name + ": ")) << value;
      EXPECT_THAT(complaint, HasSubstr(spec.allowed)) << "says what would do";
    }
  }
}

TYPED_TEST(EveryBehavior, RefusesNumbersBeyondItsRangeAndTakesItsBounds) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    double low = 0.0, high = 0.0;
    if (std::sscanf(spec.allowed.c_str(), "%lf to %lf", &low, &high) != 2) continue;
    const double step = std::max(1.0, std::abs(high));
    const bool is_clipped = spec.otherwise == "else the nearest";
    for (const double beyond : {high + step, low - step}) {
      const std::string complaint = this->ComplaintAbout(spec.name, fmt::format("{}", beyond));
      EXPECT_THAT(complaint, HasSubstr(is_clipped ? "" : "is not allowed")) << spec.name;
      EXPECT_EQ(complaint.empty(), is_clipped) << spec.name << " " << beyond;
    }
    EXPECT_EQ(this->ComplaintAbout(spec.name, fmt::format("{}", low)), "");
    EXPECT_EQ(this->ComplaintAbout(spec.name, fmt::format("{}", high)), "");
  }
}

TYPED_TEST(EveryBehavior, SaysWhatItNeedsWhenABlockLacksIt) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    if (!spec.is_required) continue;
    ConfigBlock block = BlockOf(this->entry_.describe());
    std::erase_if(block.entries, [&spec](const ConfigEntry& e) { return e.key == spec.name; });
    try {
      static_cast<void>(this->entry_.create(block));
      ADD_FAILURE() << spec.name << " is required";
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("mission.bhv:3: " + spec.name + ": is missing"));
    }
  }
}

void ExpectSound(const std::optional<Peak>& peak) {
  if (!peak) return;
  EXPECT_TRUE(std::isfinite(peak->summit));
  EXPECT_GE(peak->flat_half_width, 0.0);
  EXPECT_GT(peak->base_half_width, peak->flat_half_width) << "the helm divides by the difference";
}

/// Also of a vehicle that knows nothing of itself yet, and of one that has just stopped running.
TYPED_TEST(EveryBehavior, BidsPeaksThatTheHelmCanWeigh) {
  const auto behavior = this->entry_.create(BlockOf(this->entry_.describe()));
  VehicleState state;
  const auto tick = [&] {
    const MotionBid bid = behavior->Move(state);
    ExpectSound(bid.course);
    ExpectSound(bid.speed);
    ExpectSound(bid.depth);
  };
  tick();  // not even started
  behavior->Start(state);
  tick();
  state.area = SurveyArea{-10.0, 10.0, -10.0, 10.0, 2.0, 2.0};
  state.guidance = Guidance{.course = -3.0, .turn_rate = 0.1};
  state.nav.altitude = 0.0;
  tick();
  state.now = Seconds(-5.0);  // a clock that was set back
  tick();
  state.now = Seconds(1e6);
  state.nav.north = 500.0;
  tick();
}

TEST(BehaviorRegistry, HoldsEveryBehaviorOfThisFolder) {
  for (const char* name :
       {"BHV_ConstantDepth", "BHV_CoverArea", "BHV_FollowPath", "BHV_HoldAltitude",
        "BHV_HoldStation", "BHV_OpRegion", "BHV_ReduceMapEntropy", "BHV_ReduceObjectEntropy",
        "BHV_ReturnHome", "BHV_RevisitOpi"}) {
    EXPECT_TRUE(BehaviorRegistry().contains(name)) << name;
  }
}

}  // namespace
}  // namespace limpet
