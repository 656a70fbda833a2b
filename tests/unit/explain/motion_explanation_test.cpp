// SPDX-License-Identifier: MIT
#include "limpet/explain/motion_explanation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/explain/explanation_json.hpp"
#include "limpet/explain/explanation_text.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

MotionOpinion Wants(const char* behavior, const char* variable, double summit, double weight) {
  return {.behavior = behavior,
          .variables = variable,
          .weight = weight,
          .value = 1.0,
          .summit = summit,
          .flat_half_width = 0.0,
          .base_half_width = 90.0};
}

/// A lap of waypoints whose weight drifts, as BHV_Waypoint's does.
HelmMotion Lap(double course, double weight = 50.0) {
  return {.course_deg = course,
          .speed_mps = 0.8,
          .depth_m = {},
          .opinions = {Wants("lap", "course", course, weight), Wants("lap", "speed", 0.8, 100.0),
                       Wants("lap", "course", course + 3.0, weight / 5.0)}};
}

class ChangesOfMotionTest : public ::testing::Test {
 protected:
  void Say(double time, const HelmMotion& motion) {
    log_.Take("HELM_MOTION", std::get<std::string>(TopicCodec<HelmMotion>::Encode(motion)), time);
  }
  void Say(double time, const LoggedWord& word) { log_.Take(word, time); }
  [[nodiscard]] std::vector<std::string> Causes() const {
    std::vector<std::string> causes;
    for (const MotionChange& change : ChangesOfMotion(log_)) {
      causes.push_back(std::to_string(static_cast<int>(change.time)) + " " + change.cause);
    }
    return causes;
  }
  DecisionLog log_;
};

TEST_F(ChangesOfMotionTest, AreNoneWhereAWeightDrifts) {
  for (int second = 0; second < 100; ++second)
    Say(second, Lap(90.0 + 0.04 * second, 54.0 - 0.1 * second));
  EXPECT_THAT(Causes(), ElementsAre("0 the helm's first word"));
}

TEST_F(ChangesOfMotionTest, HaveTheirCause) {
  Say(1.0, Lap(90.0));
  Say(1.9, {"WPT_INDEX", "lap", "1.00000"});
  Say(2.0, Lap(180.0));
  Say(3.0, Lap(170.0));
  HelmMotion with_slow = Lap(170.0);
  with_slow.opinions.push_back(Wants("slow", "speed", 0.4, 500.0));
  Say(4.0, with_slow);
  Say(4.98, Lap(170.0));
  Say(5.0, {"IVPHELM_LIFE_EVENT", "", "iter=0, bname=slow, event=death"});
  Say(6.0, {"MODE", "HELM_MODE", "ACTIVE:HOME"});
  Say(6.0, Lap(170.0));
  EXPECT_THAT(Causes(), ElementsAre("1 the helm's first word", "2 lap: on to waypoint 1",
                                    "3 course 180 -> 170 deg", "4 slow bids", "4 slow ended",
                                    "6 MODE = ACTIVE:HOME"));
}

TEST_F(ChangesOfMotionTest, SayWhoseWishCountsMost) {
  HelmMotion motion = Lap(90.0);
  motion.opinions.push_back(Wants("hold", "course", 92.0, 20.0));
  Say(1.0, motion);
  motion.opinions.back().weight = 63.0;
  Say(2.0, motion);
  motion.opinions.back().weight = 200.0;
  Say(3.0, motion);
  EXPECT_THAT(Causes(),
              ElementsAre("1 the helm's first word", "3 course: hold counts most, not lap"))
      << "beside lap's 50 and 10, 63 is as good as level";
}

TEST_F(ChangesOfMotionTest, HaveTheStopAndTheGoingOn) {
  Say(1.0, Lap(90.0));
  Say(2.0, {"IVPHELM_STATE", "", "PARK"});
  Say(2.0, {"IVPHELM_ALLSTOP", "", "ManualOverride"});
  Say(8.0, {"IVPHELM_STATE", "", "PARK"});
  Say(9.0, Lap(91.0));  // an iteration says how it moves before its state
  Say(9.001, {"IVPHELM_STATE", "", "DRIVE"});
  Say(9.001, {"IVPHELM_ALLSTOP", "", "clear"});
  Say(10.0, Lap(91.0));
  EXPECT_THAT(Causes(), ElementsAre("1 the helm's first word", "2 stopped: ManualOverride",
                                    "9 goes on after ManualOverride"));
  EXPECT_EQ(ChangesOfMotion(log_)[2].motion.motion.course_deg, 91.0);

  ASSERT_TRUE(log_.MotionAt(5.0));
  const Explanation stopped = ExplainMotion(*log_.MotionAt(5.0));
  EXPECT_THAT(PlainText(FrameOfMotion(stopped)), HasSubstr("stopped since 2.0 s: ManualOverride"));
  const auto motion = nlohmann::json::parse(JsonOf(stopped, "")).at("motion");
  EXPECT_EQ(motion.at("stopped"), "ManualOverride");
  EXPECT_TRUE(motion.at("course_deg").is_null());
  EXPECT_TRUE(motion.at("bids").empty());
  EXPECT_EQ(log_.MotionAt(9.5)->motion.course_deg, 91.0);
  EXPECT_FALSE(log_.MotionAt(9.5)->stopped);
}

TEST_F(ChangesOfMotionTest, SayNothingOfBeforeAStopThatIsOver) {
  Say(1.0, Lap(90.0));
  Say(2.0, {"IVPHELM_ALLSTOP", "", "StaleNav"});
  Say(9.0, {"IVPHELM_ALLSTOP", "", "clear"});
  EXPECT_EQ(log_.MotionAt(9.2)->motion.course_deg, std::nullopt);
  Say(9.6, Lap(300.0));
  EXPECT_EQ(log_.MotionAt(9.2)->motion.course_deg, 300.0) << "the first word after it";
}

TEST_F(ChangesOfMotionTest, TellTwoWishesOfOneBehaviorApart) {
  Say(1.0, Lap(90.0));
  const std::string text = PlainText(FrameOfMotions(ChangesOfMotion(log_)));
  EXPECT_THAT(text, HasSubstr("lap: course 90 deg, lap: speed 0.8 m/s, "
                              "lap: course 93 deg (present course)"));
}

TEST_F(ChangesOfMotionTest, OfASurveyAreItsStops) {
  Say(1.0, {"IVPHELM_ALLSTOP", "", "MissingNav"});
  Say(5.0, {"IVPHELM_ALLSTOP", "", "clear"});
  Say(99.0, {"IVPHELM_ALLSTOP", "", "ManualOverride"});
  const std::vector<LoggedDecision> decisions{{.time = 10.0, .bids = {}}};
  const std::string text = PlainText(ChangesOf(decisions, StopsOf(log_)));
  const std::size_t decision = text.find("nothing, of 0 options");
  ASSERT_NE(decision, std::string::npos);
  EXPECT_LT(text.find("goes on after MissingNav"), decision);
  EXPECT_GT(text.find("stopped: ManualOverride"), decision);
}

}  // namespace
}  // namespace limpet
