// SPDX-License-Identifier: MIT
#include "limpet/helm/answer_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::Eq;
using ::testing::HasSubstr;
using ::testing::Optional;

class AnswerWatchTest : public ::testing::Test {
 protected:
  /// `owner` answers, which takes so long [s].
  std::optional<std::string> Answer(double takes, const std::string& owner = "slow") {
    return watch_.Ask(owner, [&] { ++asked_, time_ += Seconds(takes); });
  }

  Seconds time_{1e6};
  int asked_ = 0;
  AnswerWatch watch_{[this] { return time_; }};
};

TEST_F(AnswerWatchTest, SaysOfALateAnswerThatItWasLate) {
  EXPECT_THAT(Answer(0.5), Eq(std::nullopt));
  EXPECT_THAT(Answer(0.7), Optional(HasSubstr("for 0.70 s, more than 0.5 s")));
  EXPECT_THAT(Answer(0.01), Eq(std::nullopt));
  EXPECT_THAT(Answer(0.7), Optional(HasSubstr("for 0.70 s"))) << "not two in a row";
  EXPECT_EQ(asked_, 4);
}

TEST_F(AnswerWatchTest, LeavesOneThatIsLateTwiceInARowAloneForAHundredTimesAsLong) {
  static_cast<void>(Answer(0.6));
  EXPECT_THAT(Answer(1.0), Optional(HasSubstr("the last 1.0 s: not asked for 100 s")));
  EXPECT_EQ(asked_, 2);
  time_ += Seconds(99.0);
  EXPECT_THAT(Answer(0.0), Optional(HasSubstr("not asked for 100 s")));
  EXPECT_EQ(asked_, 2) << "it was not asked";
  EXPECT_THAT(Answer(0.0, "other"), Eq(std::nullopt)) << "others are";
  time_ += Seconds(1.0);
  EXPECT_THAT(Answer(2.0), Optional(HasSubstr("not asked for 200 s"))) << "once more, in vain";
  time_ += Seconds(200.0);
  EXPECT_THAT(Answer(0.1), Eq(std::nullopt));
  EXPECT_THAT(Answer(0.6), Optional(HasSubstr("for 0.60 s, more"))) << "it begins anew";
}

TEST_F(AnswerWatchTest, AsksAQuestionOfManyCallsNoFurtherOnceItIsLate) {
  const auto ask = [this](double each) {
    asked_ = 0;
    return watch_.AskEach("slow", 100, [&](std::size_t) { ++asked_, time_ += Seconds(each); });
  };
  EXPECT_THAT(ask(0.02), Eq(std::nullopt)) << "two seconds of a hundred calls";
  EXPECT_EQ(asked_, 100);
  EXPECT_THAT(ask(1.0), Optional(HasSubstr("it has kept the helm for 1.00 s")));
  EXPECT_EQ(asked_, 1) << "one call that is late is enough";
  EXPECT_THAT(ask(0.0), Eq(std::nullopt));
  EXPECT_THAT(ask(0.1), Optional(HasSubstr("for 3.")));
  EXPECT_NEAR(asked_, 31, 1);
  EXPECT_THAT(ask(0.1), Optional(HasSubstr("not asked for 3")));
  EXPECT_THAT(ask(0.0), Optional(HasSubstr("not asked for 3")));
  EXPECT_EQ(asked_, 0) << "it rests";
}

TEST_F(AnswerWatchTest, HoldsTheHelmUpForAHundredthOfTheTimeAtMost) {
  const Seconds begin = time_;
  double held = 0.0;
  while (time_ - begin < Seconds(10'000.0)) {
    const int before = asked_;
    static_cast<void>(Answer(1.0));
    held += asked_ - before;
    time_ += Seconds(0.1);
  }
  EXPECT_LE(held, 102.0);
  EXPECT_GE(held, 98.0) << "it gets its chances";
}

TEST_F(AnswerWatchTest, TellsOfAnyOtherCallThatTakesLong) {
  EXPECT_THAT(watch_.Time([this] { time_ += Seconds(3.0); }), Optional(HasSubstr("for 3.00 s")));
  EXPECT_THAT(watch_.Time([this] { time_ += Seconds(0.3); }), Eq(std::nullopt));
}

TEST(AnswerWatchWithoutAClock, FindsNobodyLate) {
  AnswerWatch watch{RealClock()};
  int asked = 0;
  for (int i = 0; i < 3; ++i) {
    EXPECT_THAT(watch.Ask("slow", [&asked] { ++asked; }), Eq(std::nullopt));
  }
  EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace limpet
