// SPDX-License-Identifier: MIT
// What holds for every behavior there is: of its parameters, and of its first tick.
#pragma once

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/registry.hpp"

namespace limpet {

/// A block with the least that the behavior needs.
inline ConfigBlock BlockOf(const std::vector<ParamSpec>& specs) {
  ConfigBlock block{.name = "BHV", .where = {"mission.bhv", 3}, .entries = {}};
  for (const ParamSpec& spec : specs) {
    if (spec.is_required) block.entries.push_back({spec.name, spec.example[0], {"mission.bhv", 4}});
    if (!spec.needed_unless.empty()) {
      block.entries.push_back({spec.needed_unless, "ANEW", {"mission.bhv", 5}});
    }
  }
  return block;
}

/// The test of each behavior instantiates it, under the name of its own tests.
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

inline void ExpectSound(const std::optional<Peak>& peak) {
  if (!peak) return;
  EXPECT_TRUE(std::isfinite(peak->summit));
  EXPECT_GE(peak->flat_half_width, 0.0);
  EXPECT_GT(peak->base_half_width, peak->flat_half_width) << "the helm divides by the difference";
}

TYPED_TEST_SUITE_P(EveryBehavior);

TYPED_TEST_P(EveryBehavior, IsBuiltFromItsExamples) {
  const std::vector<ParamSpec> specs = this->entry_.describe();
  ConfigBlock block = BlockOf(specs);
  EXPECT_NO_THROW(static_cast<void>(this->entry_.create(block)));
  block.entries.clear();
  for (const ParamSpec& spec : specs) {
    block.entries.push_back({spec.name, spec.example[0], {"mission.bhv", 4}});
  }
  EXPECT_NO_THROW(static_cast<void>(this->entry_.create(block))) << "its defaults, said aloud";
}

TYPED_TEST_P(EveryBehavior, RefusesAKeyThatItDoesNotHaveAndNamesTheNearest) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    const std::string misspelt = spec.name + "q";
    const std::string complaint = this->ComplaintAbout(misspelt, spec.example[0]);
    EXPECT_THAT(complaint, ::testing::HasSubstr("mission.bhv:17: " + misspelt + ": "));
    EXPECT_THAT(complaint, ::testing::HasSubstr("`" + spec.name + "`"));
  }
  EXPECT_THAT(this->ComplaintAbout("conditon", "A = 1"), ::testing::HasSubstr("`condition`"));
}

TYPED_TEST_P(EveryBehavior, RefusesWordsWhereANumberBelongs) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    if (spec.allowed == "text") continue;
    for (const char* value : {"much", "", "1e999", "nan", "3 4"}) {
      const bool is_default = spec.default_text == value && !spec.is_required;
      if (is_default) continue;
      const std::string complaint = this->ComplaintAbout(spec.name, value);
      EXPECT_THAT(complaint, ::testing::HasSubstr("mission.bhv:17: " + spec.name + ": ")) << value;
      EXPECT_THAT(complaint, ::testing::HasSubstr(spec.allowed)) << "says what would do";
    }
  }
}

TYPED_TEST_P(EveryBehavior, RefusesNumbersBeyondItsRangeAndTakesItsBounds) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    double low = 0.0, high = 0.0;
    if (std::sscanf(spec.allowed.c_str(), "%lf to %lf", &low, &high) != 2) continue;
    const double step = std::max(1.0, std::abs(high));
    const bool is_clipped = spec.otherwise == "else the nearest";
    for (const double beyond : {high + step, low - step}) {
      const std::string complaint = this->ComplaintAbout(spec.name, fmt::format("{}", beyond));
      EXPECT_THAT(complaint, ::testing::HasSubstr(is_clipped ? "" : "is not allowed")) << spec.name;
      EXPECT_EQ(complaint.empty(), is_clipped) << spec.name << " " << beyond;
    }
    EXPECT_EQ(this->ComplaintAbout(spec.name, fmt::format("{}", low)), "");
    EXPECT_EQ(this->ComplaintAbout(spec.name, fmt::format("{}", high)), "");
  }
}

TYPED_TEST_P(EveryBehavior, SaysWhatItNeedsWhenABlockLacksIt) {
  for (const ParamSpec& spec : this->entry_.describe()) {
    if (!spec.is_required) continue;
    ConfigBlock block = BlockOf(this->entry_.describe());
    std::erase_if(block.entries, [&spec](const ConfigEntry& e) { return e.key == spec.name; });
    try {
      static_cast<void>(this->entry_.create(block));
      ADD_FAILURE() << spec.name << " is required";
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(),
                  ::testing::HasSubstr("mission.bhv:3: " + spec.name + ": is missing"));
    }
  }
}

/// Also of a vehicle that knows nothing of itself yet, and of one that has just stopped running.
TYPED_TEST_P(EveryBehavior, BidsPeaksThatTheHelmCanWeigh) {
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

REGISTER_TYPED_TEST_SUITE_P(EveryBehavior, IsBuiltFromItsExamples,
                            RefusesAKeyThatItDoesNotHaveAndNamesTheNearest,
                            RefusesWordsWhereANumberBelongs,
                            RefusesNumbersBeyondItsRangeAndTakesItsBounds,
                            SaysWhatItNeedsWhenABlockLacksIt, BidsPeaksThatTheHelmCanWeigh);

}  // namespace limpet
