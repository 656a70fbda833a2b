// SPDX-License-Identifier: MIT
// Warnings of behaviors, whatever their ids: raised by the helm and cleared by it.
#include <fstream>
#include <memory>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/helm/registry.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

const WarningId kTooDeep = DeclareWarning("TOO_DEEP", {.severity = Severity::kWarning,
                                                       .raised_by = {"BHV_TestWorry"},
                                                       .meaning = "It is deep.",
                                                       .action = "Rise.",
                                                       .clears = "When it is shallow."});

/// Worries while it is deep; fails while it is very deep.
class BHV_TestWorry final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestWorry(const Params&) {}
  void Start(const VehicleState& state) override {
    if (state.nav.east > 50.0) throw std::runtime_error("off its chart");
  }
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override {
    if (state.nav.east > 50.0) throw std::runtime_error("off its chart, idle");
    return {};
  }
  [[nodiscard]] MotionBid Move(const VehicleState& state) override {
    MotionBid bid;
    if (state.nav.down > 50.0) throw std::runtime_error("beyond its tables");
    bid.speed = Peak{.summit = 1.0};
    if (state.nav.down > 5.0) {
      bid.warning = BehaviorWarning{kTooDeep, "deeper than 5 m"};
    }
    return bid;
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestWorry);

/// Takes more than half a second for its first bid.
class BHV_TestSloth final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestSloth(const Params&) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    const Seconds begin = SteadyTime();
    while (is_slow_ && SteadyTime() - begin < Seconds(0.52)) {
    }
    is_slow_ = false;
    MotionBid bid;
    bid.speed = Peak{.summit = 1.0};
    return bid;
  }

 private:
  bool is_slow_ = true;
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestSloth);

class BehaviorWarningsTest : public ::testing::Test {
 protected:
  BehaviorWarningsTest() {
    std::ofstream(folder_.path() / "mission.bhv") << R"(
Behavior = BHV_TestWorry
{
  name      = worry
  condition = CALM != true
  updates   = WORRY_UPDATES
}
)";
    MakeApp(false);
    Hear("CALM", "false");
  }
  void MakeApp(bool runs_live) {
    AppContext context;
    context.name = "pHelm";
    context.link = &link_;
    context.mission_folder = folder_.path();
    context.runs_live = runs_live;
    app_ = std::make_unique<HelmApp>(context, HelmApp::Params{});
    link_.Send(*app_, topics::kNavState, NavState{});
  }
  void Hear(const std::string& variable, const std::string& value) {
    link_.Send(*app_, Topic<std::string>{variable, ""}, value);
  }
  void Tick() {
    link_.time += Seconds(0.1);
    app_->Tick(link_.time);
  }

  TemporaryFolder folder_;
  TestLink link_;
  std::unique_ptr<HelmApp> app_;
};

TEST_F(BehaviorWarningsTest, ClearsAnyBehaviorsWarningWhenItIsOver) {
  link_.Send(*app_, topics::kNavState, NavState{.down = 6.0, .altitude = {}});
  Tick();
  EXPECT_EQ(app_->warnings().at("TOO_DEEP").text, "worry: deeper than 5 m");
  link_.Send(*app_, topics::kNavState, NavState{.down = 4.0, .altitude = {}});
  Tick();
  EXPECT_FALSE(app_->warnings().contains("TOO_DEEP"));
}

TEST_F(BehaviorWarningsTest, ClearsTheWarningOfABehaviorThatStopsRunning) {
  link_.Send(*app_, topics::kNavState, NavState{.down = 6.0, .altitude = {}});
  Tick();
  Hear("CALM", "true");
  Tick();
  EXPECT_FALSE(app_->warnings().contains("TOO_DEEP"));
}

TEST_F(BehaviorWarningsTest, SaysThatABehaviorFailsUntilItWorksAgain) {
  link_.Send(*app_, topics::kNavState, NavState{.down = 60.0, .altitude = {}});
  Tick();
  EXPECT_EQ(app_->warnings().at("BHV_FAILED_worry").text,
            "worry: it has thrown: beyond its tables");
  EXPECT_EQ(link_.Last(topics::kBehaviorError), "worry: it has thrown: beyond its tables");
  link_.Send(*app_, topics::kNavState, NavState{.down = 4.0, .altitude = {}});
  Tick();
  EXPECT_FALSE(app_->warnings().contains("BHV_FAILED_worry"));
}

TEST_F(BehaviorWarningsTest, HearsNoBidOfABehaviorThatCannotBeStartedAndSaysWhy) {
  link_.Send(*app_, topics::kNavState, NavState{.east = 60.0, .altitude = {}});
  Tick();
  EXPECT_EQ(app_->warnings().at("BHV_FAILED_worry").text, "worry: it has thrown: off its chart");
  EXPECT_EQ(link_.Last(topics::kBehaviorError), "worry: it has thrown: off its chart");
  EXPECT_EQ(link_.Last(topics::kHelmAllStop), "NothingToDo");
  link_.Send(*app_, topics::kNavState, NavState{.east = 40.0, .altitude = {}});
  Tick();
  EXPECT_FALSE(app_->warnings().contains("BHV_FAILED_worry"));
  EXPECT_EQ(link_.Last(topics::kHelmAllStop), "MissingDecVars:course,depth") << "it bids on speed";
  EXPECT_EQ(link_.Last(topics::kBehaviorError), "MissingDecVars:course,depth");
}

TEST_F(BehaviorWarningsTest, SaysThatABehaviorFailsWhileIdleAndAsksNoneWhileParked) {
  Hear("CALM", "true");
  link_.Send(*app_, topics::kManualOverride, true);
  link_.Send(*app_, topics::kNavState, NavState{.east = 60.0, .altitude = {}});
  Tick();
  EXPECT_FALSE(app_->warnings().contains("BHV_FAILED_worry"));
  link_.Send(*app_, topics::kManualOverride, false);
  Tick();
  EXPECT_EQ(app_->warnings().at("BHV_FAILED_worry").text,
            "worry: it has thrown: off its chart, idle");
  EXPECT_EQ(link_.Last(topics::kBehaviorError), "worry: it has thrown: off its chart, idle");
}

TEST_F(BehaviorWarningsTest, ALateBidIsNotHeardLiveAndIsLikeAnyOtherEmbedded) {
  std::ofstream(folder_.path() / "mission.bhv")
      << "Behavior = BHV_TestSloth\n{\n name = sloth\n}\n";
  MakeApp(true);
  Tick();
  EXPECT_THAT(app_->warnings().at("BHV_LATE_sloth").text,
              ::testing::StartsWith("sloth: it has kept the helm for "));
  EXPECT_EQ(link_.Last(topics::kHelmAllStop), "NothingToDo");
  Tick();
  EXPECT_FALSE(app_->warnings().contains("BHV_LATE_sloth"));
  EXPECT_EQ(link_.Last(topics::kHelmAllStop), "MissingDecVars:course,depth") << "it bids on speed";
  MakeApp(false);
  Tick();
  EXPECT_FALSE(app_->warnings().contains("BHV_LATE_sloth"));
  EXPECT_EQ(link_.Last(topics::kHelmAllStop), "MissingDecVars:course,depth");
}

TEST_F(BehaviorWarningsTest, ClearsTheWarningOfABadUpdateWithTheNextGoodOne) {
  Hear("WORRY_UPDATES", "nonsense = 3");
  Tick();
  EXPECT_TRUE(app_->warnings().contains("BHV_UPDATE_worry"));
  Hear("WORRY_UPDATES", "pwt = 3");
  Tick();
  EXPECT_FALSE(app_->warnings().contains("BHV_UPDATE_worry"));
}

}  // namespace
}  // namespace limpet
