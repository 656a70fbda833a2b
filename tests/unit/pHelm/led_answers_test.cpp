// SPDX-License-Identifier: MIT
#include "apps/pHelm/led_answers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::Eq;
using ::testing::Optional;

TEST(LedAnswers, AreMissedAfterTenSecondsAndBeforeThatNot) {
  LedAnswers answers;
  EXPECT_THAT(answers.Complaint(Seconds(0.0)), Eq(std::nullopt)) << "nothing was sent";
  answers.Sent("WAY", Seconds(5.0));
  answers.Sent("WAY", Seconds(14.0));
  EXPECT_THAT(answers.Complaint(Seconds(15.0)), Eq(std::nullopt));
  EXPECT_THAT(answers.Complaint(Seconds(15.1)), Optional(std::string("nobody answers to WAY")));
  answers.Hear("bhv=home,var=HOME_UPDATES,time=3.00,result=success,val=speed=2");
  EXPECT_TRUE(answers.Complaint(Seconds(15.1))) << "that was for another";
  answers.Hear("bhv=led,var=WAY,time=4.00,result=duplicate,val=points = 1,2:3,4");
  EXPECT_THAT(answers.Complaint(Seconds(99.0)), Eq(std::nullopt));
}

TEST(LedAnswers, ARefusalStandsUntilAnUpdateIsTaken) {
  LedAnswers answers;
  answers.Sent("WAY", Seconds(1.0));
  answers.Sent("DEEP", Seconds(1.0));
  answers.Hear("bhv=led,var=WAY,time=1.00,result=param_error,val=points = 1,2,result=success");
  answers.Hear("bhv=deep,var=DEEP,time=1.00,result=success,val=depth = 3");
  EXPECT_THAT(answers.Complaint(Seconds(2.0)),
              Optional(std::string("its behavior led does not take WAY")));
  answers.Sent("WAY", Seconds(3.0));
  answers.Hear("bhv=led,var=WAY,time=3.00,result=success,val=points = 1,2");
  EXPECT_THAT(answers.Complaint(Seconds(4.0)), Eq(std::nullopt));
}

TEST(LedAnswers, TextThatIsNoAnswerIsNone) {
  LedAnswers answers;
  answers.Sent("WAY", Seconds(0.0));
  for (const char* text : {"", "var", "var=", "bhv=x,result=success", "=,=,var=way,result="}) {
    answers.Hear(text);
  }
  EXPECT_THAT(answers.Complaint(Seconds(11.0)), Optional(std::string("nobody answers to WAY")));
}

}  // namespace
}  // namespace limpet
