// SPDX-License-Identifier: MIT
// A behavior may throw wherever the helm calls it: that costs it the call, and nobody else
// anything.
#include "limpet/helm/hosted_behavior.hpp"

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Throws in those of its functions that the test names.
class BHV_ThrowProbe final : public Behavior {
 public:
  struct Params {
    double size = 1.0;
    template <class V>
    void Describe(V& visit) {
      visit("size", size, "Its size", InRange(0.0, 10.0));
    }
  };
  explicit BHV_ThrowProbe(const Params&) { Enter("constructor"); }
  [[nodiscard]] std::vector<std::string> Variables() const override {
    Enter("Variables");
    return {};
  }
  [[nodiscard]] std::optional<std::string> Macro(std::string_view,
                                                 const VehicleState&) const override {
    Enter("Macro");
    return "0";
  }
  [[nodiscard]] bool TakeOver(const Behavior&, const std::vector<std::string>&) override {
    Enter("TakeOver");
    return true;
  }
  [[nodiscard]] bool IsPerpetual() const override {
    Enter("IsPerpetual");
    return false;
  }
  void Restart() override { Enter("Restart"); }
  void Complete(const VehicleState&) override { Enter("Complete"); }
  void Start(const VehicleState&) override { Enter("Start"); }
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState&) override {
    Enter("Stop");
    return {BehaviorPost{.variable = "STOPPED", .value = 1.0}};
  }
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState&) override {
    Enter("Idle");
    return {BehaviorPost{.variable = "IDLE", .value = 1.0}};
  }
  [[nodiscard]] bool WantsView() const override {
    Enter("WantsView");
    return true;
  }

  static void Enter(const std::string& function) {
    ++entered[function];
    time += takes[function];
    if (throws_in.contains(function)) throw std::runtime_error("in " + function);
  }
  static inline std::set<std::string> throws_in;
  static inline std::map<std::string, int> entered;
  static inline Seconds time{0.0};                     ///< real, of the test
  static inline std::map<std::string, Seconds> takes;  ///< how long a call lasts
};
LIMPET_REGISTER_BEHAVIOR(BHV_ThrowProbe);

class ThrowingBehavior : public ::testing::Test {
 protected:
  ThrowingBehavior() { Reset(); }
  ~ThrowingBehavior() override { Reset(); }
  static void Reset() {
    BHV_ThrowProbe::throws_in.clear(), BHV_ThrowProbe::entered.clear();
    BHV_ThrowProbe::takes.clear();
  }

  void Make(const std::string& lines = "") {
    const std::string block = "Behavior = BHV_ThrowProbe\n{\n  updates = UP\n  name = ";
    host_ = std::make_unique<BehaviorHost>(
        std::vector<BehaviorFile>{ParseBehaviors(
            block + "first\n  condition = GO = true\n" + lines + "}\n" + block + "second\n}\n",
            "m.bhv")},
        [] { return BHV_ThrowProbe::time; });
    Say("GO", "true");
  }
  void Say(const std::string& variable, const std::string& value) {
    host_->SetVariable(variable, value, state_.now);
  }
  /// The names of those that may bid.
  std::vector<std::string> Iterate(std::vector<BehaviorAct> acts_of_first = {}) {
    state_.now += Seconds(1.0);
    static_cast<void>(host_->Update(state_));
    std::vector<std::string> names;
    for (const WeightedBehavior& running : host_->running())
      names.push_back(running.name);
    const std::vector<BehaviorTurn> turns{{"first", std::move(acts_of_first)}};
    static_cast<void>(host_->Settle({.turns = turns, .active = {}}, state_));
    return names;
  }
  std::vector<std::string> LateCalls() {
    std::vector<std::string> texts;
    for (const OwnedWarning& late : host_->TakeLateCalls())
      texts.push_back(late.warning.id.name() + ": " + late.warning.text);
    return texts;
  }
  std::vector<std::string> Failures() {
    std::vector<std::string> texts;
    for (const BehaviorFailure& failure : host_->TakeFailures())
      texts.push_back(failure.owner + ": " + failure.text);
    return texts;
  }

  std::unique_ptr<BehaviorHost> host_;
  VehicleState state_;
};

TEST_F(ThrowingBehavior, ThatCannotBeStartedDoesNotBidUntilItCan) {
  BHV_ThrowProbe::throws_in = {"Start"};
  Make();
  EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(Failures(),
              ElementsAre("first: it has thrown: in Start", "second: it has thrown: in Start"));
  EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(Failures(), SizeIs(2)) << "tried again each time";
  BHV_ThrowProbe::throws_in.clear();
  EXPECT_THAT(Iterate(), ElementsAre("first", "second"));
  EXPECT_THAT(Failures(), IsEmpty());
  BHV_ThrowProbe::entered.clear();
  EXPECT_THAT(Iterate(), ElementsAre("first", "second"));
  EXPECT_EQ(BHV_ThrowProbe::entered["Start"], 0) << "started once";
}

TEST_F(ThrowingBehavior, LosesWhatItDoesWhileIdleAndTheOtherGoesOn) {
  Make();
  Say("GO", "false");
  BHV_ThrowProbe::throws_in = {"Idle"};
  EXPECT_THAT(Iterate(), ElementsAre("second"));
  EXPECT_THAT(Failures(), ElementsAre("first: it has thrown: in Idle"));
}

TEST_F(ThrowingBehavior, CeasesToRunAlsoIfItThrowsThen) {
  Make();
  EXPECT_THAT(Iterate(), ElementsAre("first", "second"));
  BHV_ThrowProbe::throws_in = {"Stop"};
  Say("GO", "false");
  EXPECT_THAT(Iterate(), ElementsAre("second"));
  EXPECT_THAT(Failures(), ElementsAre("first: it has thrown: in Stop"));
  EXPECT_THAT(Iterate(), ElementsAre("second"));
  EXPECT_THAT(Failures(), IsEmpty());
}

TEST_F(ThrowingBehavior, EndsAlsoIfItThrowsThen) {
  for (const char* function : {"Complete", "IsPerpetual", "Stop", "Macro"}) {
    BHV_ThrowProbe::throws_in.clear();
    Make("  endflag = OVER = $[SIZE]\n");
    BHV_ThrowProbe::throws_in = {function};
    EXPECT_THAT(Iterate({Completion{}}), ElementsAre("first", "second"));
    EXPECT_THAT(Failures(), ElementsAre("first: it has thrown: in " + std::string(function)));
    EXPECT_THAT(Iterate(), ElementsAre("second")) << function;
  }
}

TEST_F(ThrowingBehavior, IsUpdatedAndWoundUpAsFarAsItDoesNotThrow) {
  Make("  duration = 1e6\n  duration_reset = AGAIN = true\n");
  static_cast<void>(Iterate());
  BHV_ThrowProbe::throws_in = {"Restart", "TakeOver"};
  Say("AGAIN", "true");
  Say("UP", "name = first # size = 2");
  EXPECT_THAT(Iterate(), ElementsAre("first", "second"));
  EXPECT_THAT(Failures(),
              ElementsAre("first: it has thrown: in Restart", "first: it has thrown: in TakeOver"));
  EXPECT_EQ(host_->statuses().at(0).good_updates, 1);
}

TEST_F(ThrowingBehavior, ThatCannotBeMadeIsARefusedBlockOrARefusedUpdate) {
  for (const char* function : {"constructor", "Variables"}) {
    BHV_ThrowProbe::throws_in = {function};
    try {
      Make();
      ADD_FAILURE() << function;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("Behavior: it has thrown: in " + std::string(function)));
    }
  }
  BHV_ThrowProbe::throws_in.clear();
  Make();
  BHV_ThrowProbe::throws_in = {"constructor"};
  Say("UP", "name = first # size = 2");
  EXPECT_THAT(Iterate(), ElementsAre("first", "second"));
  ASSERT_THAT(host_->warnings(), SizeIs(1));
  EXPECT_THAT(host_->warnings()[0].warning.text, HasSubstr("it has thrown: in constructor"));
}

TEST_F(ThrowingBehavior, ThatThrowsWhenAskedForAViewWantsNone) {
  Make();
  EXPECT_TRUE(host_->WantsView());
  BHV_ThrowProbe::throws_in = {"WantsView"};
  EXPECT_FALSE(host_->WantsView());
}

using SlowBehavior = ThrowingBehavior;

TEST_F(SlowBehavior, IsNamedIfItsEndKeepsTheHelm) {
  Make();
  BHV_ThrowProbe::takes["Complete"] = Seconds(3.0);
  EXPECT_THAT(Iterate({Completion{}}), ElementsAre("first", "second"));
  EXPECT_THAT(LateCalls(),
              ElementsAre("BHV_LATE_first: it has kept the helm for 3.00 s, more than 0.5 s"));
  EXPECT_THAT(Iterate(), ElementsAre("second"));
  EXPECT_THAT(LateCalls(), IsEmpty());
}

TEST_F(SlowBehavior, IsNotCalledForLongWhenItTakesLongIdle) {
  Make();
  Say("GO", "false");
  BHV_ThrowProbe::takes["Idle"] = Seconds(1.0);
  for (int i = 0; i < 10; ++i) {
    EXPECT_THAT(Iterate(), ElementsAre("second"));
    EXPECT_THAT(LateCalls(), SizeIs(1));
  }
  EXPECT_EQ(BHV_ThrowProbe::entered["Idle"], 2);
  BHV_ThrowProbe::time += Seconds(100.0);
  static_cast<void>(Iterate());
  EXPECT_EQ(BHV_ThrowProbe::entered["Idle"], 3);
}

}  // namespace
}  // namespace limpet
