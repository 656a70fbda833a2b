// SPDX-License-Identifier: MIT
#include "apps/pHelm/helm_journal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class HelmJournalTest : public ::testing::Test {
 protected:
  HelmIteration Iteration(std::int64_t number) const {
    return {.number = number,
            .now = Seconds(1000.0 + 0.1 * static_cast<double>(number)),
            .course_deg = 92.14,
            .speed = 0.5,
            .depth = {},
            .is_halted = false,
            .functions = 2,
            .warnings = 0,
            .modes = "MODE@ACTIVE:SURVEYING",
            .behaviors = behaviors_,
            .active = {"follow"}};
  }
  /// Values of `variable` posted since the last call, then forgets all.
  std::vector<std::string> Take(const std::string& variable) {
    std::vector<std::string> values;
    for (const auto& [name, value] : std::exchange(posts_, {})) {
      if (name == variable) {
        const auto* number = std::get_if<double>(&value);
        values.push_back(number != nullptr ? TextOf(*number) : std::get<std::string>(value));
      }
    }
    return values;
  }
  std::string SummaryOf(const HelmIteration& iteration) {
    journal_.PostIteration(iteration);
    return Take("IVPHELM_SUMMARY").at(0);
  }

  std::vector<BehaviorStatus> behaviors_{
      {.name = "cover", .type = "BHV_CoverArea", .weight = 1.0, .is_running = true},
      {.name = "follow",
       .type = "BHV_FollowPath",
       .weight = 100.0,
       .is_running = true,
       .good_updates = 3,
       .updates = 4},
      {.name = "home", .type = "BHV_ReturnHome", .weight = 1.0}};
  std::vector<std::pair<std::string, Value>> posts_;
  HelmJournal journal_{{"course:0:359:360", "speed: 0:1:21"},
                       [this](std::string variable, Value value) {
                         posts_.emplace_back(std::move(variable), std::move(value));
                       }};
};

TEST_F(HelmJournalTest, TheFirstSummaryIsWhole) {
  EXPECT_EQ(SummaryOf(Iteration(1)),
            "iter=1,utc_time=1000.10,ofnum=2,warnings=0,var=course:92.1,var=speed:0.5,halted=false,"
            "modes=MODE@ACTIVE:SURVEYING,"
            "running_bhvs=cover$1000.10$0/0,active_bhvs=follow$1000.10$100$0$0$3/4$1,"
            "disabled_bhvs=none,idle_bhvs=home$0.00$0/0,completed_bhvs=none,"
            "ivpdomain=\"speed,0,1,21:course,0,359,360\"");
}

TEST_F(HelmJournalTest, LaterSummariesSayWhatChanged) {
  static_cast<void>(SummaryOf(Iteration(1)));
  EXPECT_EQ(SummaryOf(Iteration(2)), "iter=2,utc_time=1000.20");
  HelmIteration turned = Iteration(3);
  turned.course_deg = 100.0;
  EXPECT_EQ(SummaryOf(turned), "iter=3,utc_time=1000.30,var=course:100,var=speed:0.5");
}

TEST_F(HelmJournalTest, ADepthThatNobodyBidOnIsSaidWhereItIsDecided) {
  std::string summary;
  HelmJournal journal({"course:0:359:360", "speed:0:1:21", "depth:0:20:201"},
                      [&summary](const std::string& variable, const Value& value) {
                        if (variable == "IVPHELM_SUMMARY") summary = std::get<std::string>(value);
                      });
  journal.PostIteration(Iteration(1));
  EXPECT_THAT(summary, HasSubstr("var=speed:0.5,var=depth:varbalk"));
}

TEST_F(HelmJournalTest, ASummaryIsWholeAgainForWhoAsks) {
  const std::string whole = SummaryOf(Iteration(1));
  journal_.Rejournal();
  EXPECT_EQ(SummaryOf(Iteration(1)), whole);
}

TEST_F(HelmJournalTest, NamesBehaviorsWhenTheirStateChanges) {
  journal_.PostIteration(Iteration(1));
  EXPECT_THAT(Take("IVPHELM_BHV_ACTIVE"), ElementsAre("follow"));
  journal_.PostIteration(Iteration(2));
  EXPECT_THAT(Take("IVPHELM_BHV_ACTIVE"), IsEmpty());
  HelmIteration both = Iteration(3);
  both.active = {"follow", "cover"};
  journal_.PostIteration(both);
  EXPECT_THAT(Take("IVPHELM_BHV_ACTIVE"), ElementsAre("cover,follow"));
}

TEST_F(HelmJournalTest, ABehaviorWhoseConditionsFailIsIdleHoweverItBid) {
  behaviors_[1].is_running = false;
  EXPECT_THAT(SummaryOf(Iteration(1)), HasSubstr("active_bhvs=none"));
  EXPECT_EQ(journal_.entries().at(1).state, HelmJournal::State::kIdle);
}

TEST_F(HelmJournalTest, SaysOfEachBehaviorWhatItWaitsForWhenThatChanges) {
  behaviors_[1].takes_updates = true;
  behaviors_[2].held_back_by = "RETURN = true";
  journal_.PostIteration(Iteration(1));
  EXPECT_THAT(Take("BHV_STATUS"), ElementsAre("name=cover,state=running,updates=n/a",
                                              "name=follow,pwt=100,state=active,updates=3/4",
                                              "name=home,pc=RETURN = true,state=idle,updates=n/a"));
  journal_.PostIteration(Iteration(2));
  EXPECT_THAT(Take("BHV_STATUS"), IsEmpty());
  behaviors_[2].held_back_by = "VarStarve: SONAR (stime:2)";
  journal_.PostIteration(Iteration(3));
  EXPECT_THAT(Take("BHV_STATUS"),
              ElementsAre("name=home,pc=VarStarve: SONAR (stime:2),state=idle,updates=n/a"));
}

TEST_F(HelmJournalTest, CountsIterations) {
  journal_.PostIteration(Iteration(7));
  EXPECT_THAT(Take("IVPHELM_ITER"), ElementsAre("7"));
}

}  // namespace
}  // namespace limpet
