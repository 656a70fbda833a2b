// SPDX-License-Identifier: MIT
// How behaviors end, are made by mail, and what they post meanwhile.
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
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

/// Does what the test says next.
class BHV_LifeProbe final : public Behavior {
 public:
  struct Params {
    double size = 1.0;
    template <class V>
    void Describe(V& visit) {
      visit("size", size, "Its size", InRange(0.0, 10.0));
      visit.WithoutEffect({"old_habit"});
    }
  };
  explicit BHV_LifeProbe(const Params& params) : params_(params) {}
  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState&) const override {
    return name == "SIZE" ? std::optional<std::string>(MacroNumber(params_.size)) : std::nullopt;
  }
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState&) override {
    return {BehaviorPost{.variable = "ERASED", .value = 1.0, .is_repeated = true}};
  }

 private:
  Params params_;
};
LIMPET_REGISTER_BEHAVIOR(BHV_LifeProbe);

std::string TextOfPost(const HelmPost& post) {
  const auto* number = std::get_if<double>(&post.value);
  return post.variable + "=" +
         (number != nullptr ? MacroNumber(*number) : std::get<std::string>(post.value));
}

class BehaviorLife : public ::testing::Test {
 protected:
  void Make(const std::string& lines) {
    host_ = std::make_unique<BehaviorHost>(std::vector<BehaviorFile>{
        ParseBehaviors("Behavior = BHV_LifeProbe\n{\n  name = probe\n" + lines + "}\n", "m.bhv")});
    static_cast<void>(host_->TakeLifeEvents());
  }
  /// One second later: every running behavior does `acts`. What is posted but for BHV_SETTINGS,
  /// which is in `settings_`.
  std::vector<std::string> Iterate(std::vector<BehaviorAct> acts = {}, bool is_active = false) {
    state_.now += Seconds(1.0);
    state_.ownship = "alpha";
    state_.heard = &host_->heard();
    std::vector<HelmPost> posts = host_->Update(state_);
    std::vector<BehaviorTurn> turns;
    std::vector<std::string> names;
    for (const WeightedBehavior& running : host_->running()) {
      turns.push_back({running.name, acts});
      names.push_back(running.name);
    }
    const std::vector<std::string_view> active(names.begin(), names.end());
    std::ranges::move(
        host_->Settle({.turns = turns, .active = is_active ? active : decltype(active){}}, state_),
        std::back_inserter(posts));
    std::vector<std::string> texts;
    settings_.clear();
    for (const HelmPost& post : posts) {
      (post.variable == "BHV_SETTINGS" ? settings_ : texts).push_back(TextOfPost(post));
    }
    return texts;
  }
  void Say(const std::string& variable, const Value& value) {
    host_->SetVariable(variable, value, state_.now);
  }
  [[nodiscard]] std::vector<std::string> Living() const {
    std::vector<std::string> names;
    for (const BehaviorStatus& status : host_->statuses())
      names.push_back(status.name);
    return names;
  }

  std::unique_ptr<BehaviorHost> host_;
  VehicleState state_;
  std::vector<std::string> settings_;
};

TEST_F(BehaviorLife, EndsWithItsEndFlagsOnceItHasCompleted) {
  Make("  endflag = RETURN = true\n  endflag = BY = $[BHVNAME]\n");
  EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(Iterate({Completion{.reason = "there"}}),
              ElementsAre("RETURN=true", "BY=probe", "ERASED=1"));
  EXPECT_TRUE(host_->statuses().at(0).is_complete) << "seen by displays in this iteration";
  EXPECT_THAT(host_->TakeLifeEvents(), ElementsAre(LifeEvent{.kind = LifeEvent::Kind::kDeath,
                                                             .name = "probe",
                                                             .type = "BHV_LifeProbe",
                                                             .reason = "there"}));
  EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(Living(), IsEmpty());
}

TEST_F(BehaviorLife, OneThatIsPerpetualLivesOn) {
  Make("  endflag = RETURN = true\n  perpetual = true\n");
  EXPECT_THAT(Iterate({Completion{}}), ElementsAre("RETURN=true"));
  EXPECT_THAT(Iterate({Completion{}}), ElementsAre("RETURN=true"));
  EXPECT_THAT(Living(), ElementsAre("probe"));
}

TEST_F(BehaviorLife, CompletesWhenItsDurationIsOver) {
  Make("  duration = 3\n  duration_status = LEFT\n  endflag = OVER = true\n");
  EXPECT_THAT(Iterate(), ElementsAre("LEFT=3"));
  EXPECT_THAT(Iterate(), ElementsAre("LEFT=2"));
  EXPECT_THAT(Iterate(), ElementsAre("LEFT=1"));
  EXPECT_THAT(Iterate(), ElementsAre("LEFT=0", "OVER=true", "ERASED=1"));
  EXPECT_THAT(host_->running(), IsEmpty());
}

TEST_F(BehaviorLife, BeginsItsDurationWhenItsConditionsFirstHold) {
  Make("  condition = GO = true\n  duration = 2\n  endflag = OVER = 1\n");
  for (int i = 0; i < 5; ++i)
    EXPECT_THAT(Iterate(), IsEmpty());
  Say("GO", std::string("true"));
  EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(Iterate(), ElementsAre("OVER=1", "ERASED=1"));
}

TEST_F(BehaviorLife, LeavesIdleTimeOutOfItsDurationIfAskedTo) {
  for (const bool decays : {true, false}) {
    Make("  condition = GO = true\n  duration = 3\n  endflag = OVER = 1\n" +
         std::string(decays ? "" : "  duration_idle_decay = false\n"));
    Say("GO", std::string("true"));
    static_cast<void>(Iterate());
    static_cast<void>(Iterate());
    Say("GO", std::string("false"));
    for (int i = 0; i < 5; ++i)
      static_cast<void>(Iterate());
    Say("GO", std::string("true"));
    EXPECT_EQ(Iterate().empty(), !decays);
  }
}

TEST_F(BehaviorLife, MailWindsItsDurationUp) {
  Make("  duration = 3\n  duration_reset = AGAIN = yes\n  endflag = OVER = 1\n");
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(Iterate(), IsEmpty());
  Say("AGAIN", std::string("no"));
  Say("AGAIN", std::string("yes"));
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(Iterate(), ElementsAre("OVER=1", "ERASED=1"));
}

TEST_F(BehaviorLife, APerpetualOneWindsItsDurationUpItself) {
  Make("  duration = 2\n  perpetual = true\n  endflag = OVER = 1\n");
  std::vector<std::size_t> posts;
  for (int i = 0; i < 8; ++i)
    posts.push_back(Iterate().size());
  EXPECT_THAT(posts, ElementsAre(0, 0, 1, 0, 1, 0, 1, 0)) << "from when the last was used up";
}

TEST_F(BehaviorLife, SaysWhatHoldsItBack) {
  Make(
      "  condition = DEPLOY = true\n  condition = (DEPTH < 3) or (DEPTH > 5)\n"
      "  nostarve = SONAR, RADAR, 2\n  duration = 3\n");
  const auto held_back_by = [this] { return host_->statuses().at(0).held_back_by; };
  static_cast<void>(Iterate());
  EXPECT_EQ(held_back_by(), "DEPLOY = true") << "the first of its conditions";
  Say("DEPLOY", std::string("true"));
  Say("DEPTH", 4.0);
  static_cast<void>(Iterate());
  EXPECT_EQ(held_back_by(), "(DEPTH < 3) or (DEPTH > 5)");
  Say("DEPTH", 6.0);
  Say("SONAR", 1.0);
  static_cast<void>(Iterate());
  EXPECT_EQ(held_back_by(), "VarStarve: RADAR (stime:2)");
  Say("RADAR", 1.0);
  static_cast<void>(Iterate());
  EXPECT_EQ(held_back_by(), "");
  EXPECT_TRUE(host_->statuses().at(0).is_running);
  static_cast<void>(Iterate());
  static_cast<void>(Iterate());
  EXPECT_EQ(held_back_by(), "completed-byduration");
}

TEST_F(BehaviorLife, IsIdleWhileItsInputStarves) {
  Make("  nostarve = SONAR, RADAR, 2\n");
  static_cast<void>(Iterate());
  EXPECT_THAT(host_->running(), IsEmpty()) << "never heard";
  Say("SONAR", 1.0);
  Say("RADAR", 1.0);
  static_cast<void>(Iterate());
  static_cast<void>(Iterate());
  EXPECT_THAT(host_->running(), SizeIs(1));
  Say("SONAR", 1.0);
  static_cast<void>(Iterate());
  EXPECT_THAT(host_->running(), IsEmpty()) << "RADAR is 3 s old";
}

TEST_F(BehaviorLife, IsActiveWhileItHasASay) {
  Make("  activeflag = A = 1\n  inactiveflag = I = 1\n");
  EXPECT_THAT(Iterate({}, false), IsEmpty());
  EXPECT_THAT(Iterate({}, true), ElementsAre("A=1"));
  EXPECT_THAT(Iterate({}, true), IsEmpty());
  EXPECT_THAT(Iterate({}, false), ElementsAre("I=1"));
}

TEST_F(BehaviorLife, SaysOnceThatItWasMadeAndHowItIsConfigured) {
  Make(
      "  spawnflag = S = 1\n  spawnxflag = SX = 1\n  configflag = C = $[SIZE]\n"
      "  runflag = R = 1\n  updates = UP\n  size = 2\n");
  EXPECT_THAT(Iterate(), ElementsAre("C=2", "R=1", "SX=1")) << "a template's alone has spawnflags";
  EXPECT_THAT(settings_, ElementsAre("BHV_SETTINGS=type=BHV_LifeProbe,name=probe,size=2"));
  EXPECT_THAT(Iterate(), IsEmpty());
  EXPECT_THAT(settings_, IsEmpty());
  Say("UP", std::string("size = 4"));
  EXPECT_THAT(Iterate(), ElementsAre("C=4")) << "an update does not make it run anew";
  EXPECT_THAT(settings_, ElementsAre("BHV_SETTINGS=type=BHV_LifeProbe,name=probe,size=4"));
}

TEST_F(BehaviorLife, AnUpdateMayAddFlagsAndConditions) {
  Make("  updates = UP\n  runxflag = A = 1\n");
  EXPECT_THAT(Iterate(), ElementsAre("A=1"));
  Say("UP", std::string("runxflag = B = 2"));
  EXPECT_THAT(Iterate(), ElementsAre("A=1", "B=2"));
  Say("UP", std::string("runxflag = clearall # condition = GO = true"));
  EXPECT_THAT(Iterate(), ElementsAre("ERASED=1"));
  EXPECT_THAT(host_->Variables(), ElementsAre("GO", "UP"));
}

TEST_F(BehaviorLife, TheSameUpdateAgainCountsWhereItToggles) {
  Make("  updates = UP\n");
  for (int i = 0; i < 3; ++i)
    Say("UP", std::string("size = 3"));
  EXPECT_EQ(host_->TakeLifeEvents().size(), 0U);
  static_cast<void>(Iterate());
  EXPECT_EQ(host_->statuses().at(0).updates, 1);
  for (int i = 0; i < 3; ++i)
    Say("UP", std::string("runflag = X = toggle"));
  static_cast<void>(Iterate());
  EXPECT_EQ(host_->statuses().at(0).updates, 4);
}

TEST_F(BehaviorLife, ATemplateMakesABehaviorForEachNewName) {
  Make("  templating = spawn\n  updates = UP\n  spawnflag = BORN = $[BHVNAME]\n");
  EXPECT_THAT(Living(), IsEmpty());
  EXPECT_THAT(host_->Variables(), ElementsAre("UP"));
  Say("UP", std::string("size = 3"));
  EXPECT_THAT(Iterate(), IsEmpty()) << "no name, no behavior";
  Say("UP", std::string("name = _a # size = 3"));
  Say("UP", std::string("name = _b # size = 4"));
  EXPECT_THAT(Iterate(), ElementsAre("BORN=probe_a", "BORN=probe_b"));
  EXPECT_THAT(Living(), ElementsAre("probe_a", "probe_b"));
  EXPECT_THAT(host_->TakeLifeEvents(), ElementsAre(LifeEvent{.kind = LifeEvent::Kind::kSpawn,
                                                             .name = "probe_a",
                                                             .type = "BHV_LifeProbe",
                                                             .seed = "name = _a # size = 3"},
                                                   ::testing::Field(&LifeEvent::name, "probe_b")));
  Say("UP", std::string("name = _a # size = 5"));
  EXPECT_THAT(Iterate(), IsEmpty()) << "an update for the one that lives";
  EXPECT_EQ(host_->statuses().at(0).updates, 2) << "what made it, and this";
  EXPECT_EQ(host_->statuses().at(1).updates, 1);
}

TEST_F(BehaviorLife, ACloneTemplateLivesItselfAndItsSpawningsAreLimited) {
  Make("  templating = clone\n  updates = UP\n  max_spawnings = 1\n");
  EXPECT_THAT(Living(), ElementsAre("probe"));
  Say("UP", std::string("name = _a"));
  Say("UP", std::string("name = _b"));
  static_cast<void>(Iterate());
  EXPECT_THAT(Living(), ElementsAre("probe", "probe_a"));
}

TEST_F(BehaviorLife, ASpawningThatCannotBeMadeIsToldAndNothingElseHappens) {
  Make("  templating = spawn\n  updates = UP\n");
  Say("UP", std::string("name = _a # size = 30"));
  static_cast<void>(Iterate());
  EXPECT_THAT(Living(), IsEmpty());
  EXPECT_EQ(host_->TakeLifeEvents().at(0).kind, LifeEvent::Kind::kAbort);
  EXPECT_THAT(host_->warnings().at(0).warning.text, HasSubstr("`30` is not allowed"));
}

TEST_F(BehaviorLife, PostsWhatHasChangedAndFlagsAlways) {
  Make("  runxflag = EACH = 1\n");
  const BehaviorPost place{.variable = "VIEW_POINT", .value = std::string("x=1"), .key = "wpt"};
  BehaviorPost other = place;
  other.key = "trk";
  EXPECT_THAT(Iterate({place, other}), ElementsAre("VIEW_POINT=x=1", "VIEW_POINT=x=1", "EACH=1"));
  EXPECT_THAT(Iterate({place, other}), ElementsAre("EACH=1"));
  host_->ForgetPosts();
  EXPECT_THAT(Iterate({place}), ElementsAre("VIEW_POINT=x=1", "EACH=1"));
}

TEST_F(BehaviorLife, PostsUnderAnotherNameOrNotAtAllWhereItsBlockSaysSo) {
  Make(
      "  post_mapping = STAT, MY_STAT\n  post_mapping = ERASED, silent\n"
      "  runflag = STAT = 7\n  condition = GO = true\n");
  Say("GO", std::string("true"));
  EXPECT_THAT(Iterate(), ElementsAre("MY_STAT=7"));
  Say("GO", std::string("false"));
  EXPECT_THAT(Iterate(), IsEmpty());
}

TEST_F(BehaviorLife, FillsInTheMacrosOfFlags) {
  Make(
      "  pwt = 40\n  runxflag = W = $[OWNSHIP]:$[BHVTYPE]:$[PWT]\n  runxflag = N = $[CTR]\n"
      "  runxflag = P = $(OSX),$(OSY)\n  runxflag = H = $[OSH]\n  runxflag = V = $[OSV]\n"
      "  runxflag = T = $[DUR_RUN_TIME]/$[DUR_IDLE_TIME]\n  runxflag = S = $[NOW]\n");
  state_.nav.east = 12.5, state_.nav.north = -3.0, state_.nav.yaw = 0.0;
  state_.nav.u = 0.3, state_.nav.v = 0.4;
  EXPECT_THAT(Iterate(), ElementsAre("W=alpha:BHV_LifeProbe:40", "N=1", "P=12.5,-3", "H=0", "V=0.5",
                                     "T=0/0", "S=0"));
  EXPECT_EQ(Iterate().at(1), "N=2");
  EXPECT_THAT(Iterate(), ::testing::IsSupersetOf({"T=1/0", "S=2", "N=3"}));
}

TEST_F(BehaviorLife, AHashIsLettersAndDigitsThatDoNotComeAgain) {
  Make("  runxflag = ID = $[HASH4]\n  runxflag = ID = $[HASH]\n");
  const std::vector<std::string> posts = Iterate();
  EXPECT_EQ(posts.at(0).size(), 3U + 4U);
  EXPECT_EQ(posts.at(1).size(), 3U + 6U);
  EXPECT_NE(Iterate(), posts);
}

TEST_F(BehaviorLife, AFlagMayHaveAConditionAndMayGoToOtherVehicles) {
  Make("  runxflag = A = 1 [if] GO = true\n  runxflag = #all+ B = 2\n  runxflag = #all C = x\n");
  const std::string envelope =
      "NODE_MESSAGE_LOCAL=src_node=alpha,dest_node=all,src_app=pHelm,"
      "src_bhv=probe,var_name=";
  EXPECT_THAT(Iterate(),
              ElementsAre("B=2", envelope + "B,double_val=2", envelope + "C,string_val=\"x\""));
  Say("GO", std::string("true"));
  EXPECT_EQ(Iterate().at(0), "A=1");
}

TEST_F(BehaviorLife, AFlagMayGoToTheVehiclesGroup) {
  Make("  runxflag = #group+ B = 2\n  runxflag = #group C = x\n");
  EXPECT_THAT(host_->Variables(), ElementsAre("NODE_REPORT_LOCAL"));
  Say("NODE_REPORT_LOCAL", std::string("NAME=alpha,X=1,Y=2,SPD=0,HDG=0,GROUP=blue"));
  const std::string envelope =
      "NODE_MESSAGE_LOCAL=src_node=alpha,dest_node=all,dest_group=blue,src_app=pHelm,"
      "src_bhv=probe,var_name=";
  EXPECT_THAT(Iterate(),
              ElementsAre("B=2", envelope + "B,double_val=2", envelope + "C,string_val=\"x\""));
  EXPECT_THROW(Make("  runflag = #blue A = 1\n"), ConfigError);
}

TEST_F(BehaviorLife, SaysWhichKeysOfItsBlockNobodyHeeds) {
  Make("  old_habit = 3\n  build_info = uniform_piece=discrete\n");
  ASSERT_THAT(host_->warnings(), SizeIs(1));
  EXPECT_EQ(host_->warnings()[0].warning.id.name(), "BHV_KEYS_probe");
  EXPECT_EQ(host_->warnings()[0].warning.text, "without effect: old_habit, build_info");
}

}  // namespace
}  // namespace limpet
