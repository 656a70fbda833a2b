// SPDX-License-Identifier: MIT
// When behaviors run, what they post then, and what mail may change of them.
#include "limpet/helm/behavior_host.hpp"

#include <algorithm>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class BHV_HostProbe final : public Behavior {
 public:
  struct Params {
    Meters size{1.0};
    template <class V>
    void Describe(V& visit) {
      visit("size_m", size, "Its size", InRange(Meters(0.0), Meters(10.0)));
    }
  };
  explicit BHV_HostProbe(const Params& params) : params_(params) {}
  void Start(const VehicleState&) override { ++starts; }
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    MotionBid bid;
    bid.depth = Peak{.summit = params_.size.value()};
    return bid;
  }
  static inline int starts = 0;

 private:
  Params params_;
};
LIMPET_REGISTER_BEHAVIOR(BHV_HostProbe);

class BehaviorHostTest : public ::testing::Test {
 protected:
  static std::unique_ptr<BehaviorHost> HostOf(const std::string& lines,
                                              const std::string& before = "") {
    return std::make_unique<BehaviorHost>(std::vector<BehaviorFile>{ParseBehaviors(
        before + "Behavior = BHV_HostProbe\n{\n  name = probe\n" + lines + "}\n", "m.bhv")});
  }
  static std::string ComplaintAbout(const std::string& lines) {
    try {
      static_cast<void>(HostOf(lines));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  static std::vector<std::string> Variables(const std::vector<HelmPost>& posts) {
    std::vector<std::string> names;
    for (const HelmPost& post : posts) {
      if (post.variable != "BHV_SETTINGS") names.push_back(post.variable);
    }
    return names;
  }
  /// One iteration: what is posted before and after the bids, but for BHV_SETTINGS; whoever runs
  /// has a say.
  static std::vector<HelmPost> Iterate(BehaviorHost& host, const VehicleState& state = {}) {
    std::vector<HelmPost> posts = host.Update(state);
    std::vector<std::string> names;
    for (const WeightedBehavior& running : host.running()) {
      names.push_back(running.name);
    }
    const std::vector<std::string_view> active(names.begin(), names.end());
    std::ranges::move(host.Settle({.turns = {}, .active = active}, state),
                      std::back_inserter(posts));
    std::erase_if(posts, [](const HelmPost& post) { return post.variable == "BHV_SETTINGS"; });
    return posts;
  }
  static double Summit(BehaviorHost& host) {
    return host.running().at(0).behavior->Move({}).depth->summit;
  }
};

TEST_F(BehaviorHostTest, RunsABehaviorWhileAllItsConditionsHold) {
  const auto host = HostOf("  condition = DEPLOY = true\n  condition = DEPTH < 3\n");
  static_cast<void>(host->Update({}));
  EXPECT_THAT(host->running(), IsEmpty()) << "what nobody has said holds no condition";
  host->SetVariable("DEPLOY", std::string("true"));
  host->SetVariable("DEPTH", 2.0);
  static_cast<void>(host->Update({}));
  EXPECT_THAT(host->running(), SizeIs(1));
  host->SetVariable("DEPTH", 3.5);
  static_cast<void>(host->Update({}));
  EXPECT_THAT(host->running(), IsEmpty());
  EXPECT_THAT(host->Variables(), ElementsAre("DEPLOY", "DEPTH"));
}

TEST_F(BehaviorHostTest, StartsABehaviorEachTimeThatItBeginsToRun) {
  const auto host = HostOf("  condition = GO = true\n");
  BHV_HostProbe::starts = 0;
  for (int round = 1; round <= 3; ++round) {
    host->SetVariable("GO", std::string("true"));
    static_cast<void>(host->Update({}));
    static_cast<void>(host->Update({}));
    EXPECT_EQ(BHV_HostProbe::starts, round);
    host->SetVariable("GO", std::string("false"));
    static_cast<void>(host->Update({}));
  }
}

TEST_F(BehaviorHostTest, PostsEachFlagWhenItsTimeHasCome) {
  const auto host = HostOf(
      "  condition = GO = true\n  runflag = RUN = 1\n  runxflag = EACH = 1\n"
      "  activeflag = ACTIVE = 1\n  inactiveflag = INACTIVE = 1\n  idleflag = IDLE = 1\n");
  EXPECT_THAT(Variables(Iterate(*host)), ElementsAre("IDLE", "INACTIVE")) << "at first, too";
  EXPECT_THAT(Iterate(*host), IsEmpty());
  host->SetVariable("GO", std::string("true"));
  EXPECT_THAT(Variables(Iterate(*host)), ElementsAre("RUN", "EACH", "ACTIVE"));
  EXPECT_THAT(Variables(Iterate(*host)), ElementsAre("EACH"));
  host->SetVariable("GO", std::string("false"));
  EXPECT_THAT(Variables(Iterate(*host)), ElementsAre("IDLE", "INACTIVE"));
  EXPECT_THAT(Iterate(*host), IsEmpty());
}

TEST_F(BehaviorHostTest, TakesKeysInAnyCaseAsMoosFilesHaveThem) {
  const auto host = HostOf(
      "  Condition = GO = true\n  RunFlag = RUN = 1\n  IDLEFLAG = IDLE = 1\n"
      "  PWT = 40\n  UPDATES = PROBE_UPDATES\n");
  host->SetVariable("GO", std::string("true"));
  EXPECT_THAT(Variables(Iterate(*host)), ElementsAre("RUN"));
  EXPECT_EQ(host->running().at(0).weight, 40.0);
  host->SetVariable("GO", std::string("false"));
  EXPECT_THAT(Variables(Iterate(*host)), ElementsAre("IDLE"));
  EXPECT_THAT(host->Variables(), ElementsAre("GO", "PROBE_UPDATES"));
}

TEST_F(BehaviorHostTest, FillsInWhatAFlagAsksFor) {
  const auto host = HostOf("  runflag = WHO = $[BHVNAME]\n  runflag = WHERE = $[OSX]\n");
  VehicleState state;
  state.nav.east = 12.5;
  const std::vector<HelmPost> posts = Iterate(*host, state);
  ASSERT_THAT(posts, SizeIs(2));
  EXPECT_EQ(posts[0].value, Value(std::string("probe")));
  EXPECT_EQ(posts[1].value, Value(12.5));
  EXPECT_EQ(posts[0].aux, "probe");
}

TEST_F(BehaviorHostTest, AnUpdateChangesItsParametersFromThenOn) {
  const auto host = HostOf("  updates = UP\n  size_m = 2\n");
  static_cast<void>(host->Update({}));
  EXPECT_EQ(Summit(*host), 2.0);
  host->SetVariable("UP", std::string("size_m = 3 # pwt = 7"));
  static_cast<void>(host->Update({}));
  EXPECT_EQ(Summit(*host), 3.0);
  EXPECT_EQ(host->running().at(0).weight, 7.0);
  EXPECT_EQ(host->statuses().at(0).good_updates, 1);
  EXPECT_EQ(host->statuses().at(0).updates, 1);
}

TEST_F(BehaviorHostTest, SaysWhatBecameOfEachUpdateAsStockHelmsDo) {
  const auto host = HostOf("  updates = UP\n  endflag = DONE = true\n");
  VehicleState state;
  state.now = Seconds(100.0);
  static_cast<void>(host->Update(state));  // times are since then
  for (const char* text : {"pwt = 3", "pwt = 3", "pwt = fast", "name = other # pwt = 4"}) {
    host->SetVariable("UP", Value(std::string(text)), Seconds(101.5));
  }
  EXPECT_THAT(host->TakeUpdateResults(),
              ElementsAre("bhv=probe,var=UP,time=1.50,result=success,val=pwt = 3",
                          "bhv=probe,var=UP,time=1.50,result=duplicate,val=pwt = 3",
                          "bhv=probe,var=UP,time=1.50,result=param_error,val=pwt = fast",
                          "bhv=probe,var=UP,time=1.50,result=name_mismatch,val=name = other # "
                          "pwt = 4"));
  EXPECT_THAT(host->TakeUpdateResults(), IsEmpty());
  EXPECT_EQ(host->UpdateVariables(), "probe=UP");
  EXPECT_THAT(host->PostedVariables(), ElementsAre("DONE"));
}

TEST_F(BehaviorHostTest, AnUpdateThatNamesAnotherBehaviorIsNotForThisOne) {
  const auto host = HostOf("  updates = UP\n  size_m = 2\n");
  host->SetVariable("UP", std::string("name = other # size_m = 3"));
  static_cast<void>(host->Update({}));
  EXPECT_EQ(Summit(*host), 2.0);
  host->SetVariable("UP", std::string("name = probe # size_m = 4"));
  static_cast<void>(host->Update({}));
  EXPECT_EQ(Summit(*host), 4.0);
}

TEST_F(BehaviorHostTest, ABadUpdateLeavesItAsItWasAndSaysWhy) {
  for (const char* text : {"size_m = 11", "size_m = big", "sise_m = 3", "pwt = -1", "pwt = heavy",
                           "PWT = -0.5", "condition = ((", "runflag = nonsense"}) {
    const auto host = HostOf("  updates = UP\n  size_m = 2\n  pwt = 10\n");
    host->SetVariable("UP", std::string(text));
    const std::vector<HelmPost> posts = host->Update({});
    EXPECT_EQ(Summit(*host), 2.0) << text;
    EXPECT_EQ(host->running().at(0).weight, 10.0) << text;
    ASSERT_THAT(host->warnings(), SizeIs(1)) << text;
    EXPECT_EQ(host->warnings()[0].warning.id.name(), "BHV_UPDATE_probe");
    EXPECT_THAT(host->warnings()[0].warning.text, HasSubstr("UP: ")) << "names the mail";
    EXPECT_THAT(Variables(posts), ElementsAre("BHV_WARNING", "BHV_CONFIG_WARNING"));
    EXPECT_EQ(host->statuses().at(0).good_updates, 0) << text;
    EXPECT_EQ(host->statuses().at(0).updates, 1) << text;
    host->SetVariable("UP", std::string("size_m = 5"));
    EXPECT_THAT(host->warnings(), IsEmpty()) << "the next good one clears it";
  }
}

TEST_F(BehaviorHostTest, AppliesTheGoodPartsOfAnUpdateThatHasABadOne) {
  const auto host = HostOf("  updates = UP\n  size_m = 2\n  pwt = 10\n");
  host->SetVariable("UP", std::string("size_m = 3 # speling = 1 # pwt = -1"));
  const std::vector<HelmPost> posts = host->Update({});
  EXPECT_EQ(Summit(*host), 3.0);
  EXPECT_EQ(host->running().at(0).weight, 10.0);
  EXPECT_EQ(posts.at(0).value, Value(std::string("Faulty update for behavior: probe. "
                                                 "Bad parameter(s): speling,pwt")));
}

TEST_F(BehaviorHostTest, TheSameUpdateTwiceIsOne) {
  const auto host = HostOf("  updates = UP\n");
  for (int i = 0; i < 3; ++i)
    host->SetVariable("UP", std::string("size_m = 3"));
  static_cast<void>(host->Update({}));
  EXPECT_EQ(host->statuses().at(0).updates, 1);
}

TEST_F(BehaviorHostTest, RefusesABadFileWithEveryProblemAndItsLine) {
  const std::string complaint =
      ComplaintAbout("  pwt = -3\n  size_m = 11\n  runflag = nonsense\n  sise_m = 2\n");
  EXPECT_THAT(complaint, HasSubstr("m.bhv:4: pwt: `-3` is not allowed; allowed: at least 0"));
  EXPECT_THAT(complaint, HasSubstr("m.bhv:5: size_m: `11` is not allowed; allowed: 0 to 10 m"));
  EXPECT_THAT(complaint, HasSubstr("m.bhv:6: runflag: "));
  EXPECT_THAT(complaint, HasSubstr("m.bhv:7: sise_m: "));
  EXPECT_THAT(complaint, HasSubstr("`size_m`"));
}

TEST_F(BehaviorHostTest, RefusesAnUpdatesVariableThatMailCannotHave) {
  EXPECT_THAT(ComplaintAbout("  updates = UP DATES\n"),
              HasSubstr("m.bhv:4: updates: `UP DATES` is not allowed; allowed: one VARIABLE"));
  EXPECT_EQ(ComplaintAbout("  updates =\n"), "") << "none";
}

TEST_F(BehaviorHostTest, RefusesACommsPolicyThatThereIsNot) {
  EXPECT_THAT(ComplaintAbout("  comms_policy = leen\n"),
              HasSubstr("m.bhv:4: comms_policy: `leen` is not allowed; allowed: open, lean, dire; "
                        "did you mean `lean`?"));
  EXPECT_THAT(ComplaintAbout("  comms_policy = silly\n"), HasSubstr("allowed: open, lean, dire"));
  EXPECT_EQ(ComplaintAbout("  comms_policy = Dire\n"), "");
}

TEST_F(BehaviorHostTest, NamesTheNearestOfABehaviorThatThereIsNot) {
  try {
    const BehaviorHost host({ParseBehaviors("Behavior = BHV_HostProb\n{\n}\n", "m.bhv")});
    FAIL() << "there is no such behavior";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no behavior `BHV_HostProb`; nearest known: "
                                        "`BHV_HostProbe`"));
  }
}

TEST_F(BehaviorHostTest, AModeDecidesWhatRuns) {
  const auto host = HostOf("  condition = MODE == ACTIVE\n",
                           "set MODE = ACTIVE {\n  DEPLOY = true\n} INACTIVE\n\n");
  EXPECT_THAT(Variables(host->Update({})), ElementsAre("MODE"));
  EXPECT_EQ(host->modes(), "MODE@INACTIVE");
  EXPECT_THAT(host->running(), IsEmpty());
  host->SetVariable("DEPLOY", std::string("true"));
  EXPECT_THAT(Variables(host->Update({})), ElementsAre("MODE"));
  EXPECT_THAT(host->running(), SizeIs(1)) << "in the same iteration";
  EXPECT_THAT(host->Update({}), IsEmpty()) << "a mode is posted when it changes";
}

TEST_F(BehaviorHostTest, PostsInitialValuesUnlessSomebodyHasSpoken) {
  const auto host = HostOf("", "initialize A = 1\ninitialize_ B = 2\n");
  EXPECT_THAT(Variables(host->InitialPosts()), ElementsAre("A", "B"));
  host->SetVariable("A", 5.0);
  host->SetVariable("B", 5.0);
  EXPECT_THAT(Variables(host->InitialPosts()), ElementsAre("A"));
}

TEST(BehaviorSettings, ReplaceAKeyOfTheBehaviorThatTheyName) {
  std::vector<BehaviorFile> files{
      ParseBehaviors("Behavior = BHV_HostProbe\n{\n  name = probe\n  Size_m = 2\n}\n", "m.bhv")};
  ApplyBehaviorSettings(files, {"probe.size_m=4", "probe.pwt=3"});
  BehaviorHost host(files);
  static_cast<void>(host.Update({}));
  EXPECT_EQ(host.running().at(0).behavior->Move({}).depth->summit, 4.0);
  EXPECT_EQ(host.running().at(0).weight, 3.0);
}

TEST(BehaviorSettings, NameTheNearestBehaviorAndTheSettingThatIsWrong) {
  std::vector<BehaviorFile> files{
      ParseBehaviors("Behavior = BHV_HostProbe\n{\n  name = probe\n}\n", "m.bhv")};
  try {
    ApplyBehaviorSettings(files, {"prob.size_m=4"});
    FAIL() << "there is no such behavior";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nearest behavior: `probe`"));
  }
  try {
    ApplyBehaviorSettings(files, {"BHV_HostProbe.size_m=4"});
    FAIL() << "a type is no name";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("behaviors: `probe`"));
  }
  ApplyBehaviorSettings(files, {"probe.size_m=40"});
  try {
    const BehaviorHost host(files);
    FAIL() << "40 m is too large";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--set probe.size_m=40: size_m: `40` is not allowed"));
  }
}

}  // namespace
}  // namespace limpet
