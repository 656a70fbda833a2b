// SPDX-License-Identifier: MIT
#include "apps/pHelm/mail_skew.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;

TEST(MailSkew, LeavesOutWhatIsTooOldOrOfTheFuture) {
  MailSkew skew(Seconds(10.0));
  skew.Begin("DEPLOY", Seconds(0.0));
  EXPECT_FALSE(skew.Refuse("DEPLOY", Seconds(95.0), Seconds(100.0)));
  EXPECT_THAT(skew.Refuse("DEPLOY", Seconds(85.0), Seconds(100.0)).value(),
              HasSubstr("DEPLOY of 15.0 s ago"));
  EXPECT_TRUE(skew.is_refusing());
  EXPECT_THAT(skew.Refuse("DEPLOY", Seconds(112.0), Seconds(100.0)).value(),
              HasSubstr("12.0 s ahead"));
  EXPECT_FALSE(skew.Refuse("DEPLOY", Seconds(100.0), Seconds(100.0)));
  EXPECT_FALSE(skew.is_refusing());
}

TEST(MailSkew, HearsWhatWasWrittenLongBeforeItAsked) {
  MailSkew skew(Seconds(10.0));
  skew.Begin("DEPLOY", Seconds(1000.0));
  EXPECT_FALSE(skew.Refuse("DEPLOY", Seconds(200.0), Seconds(1001.0)));
  EXPECT_TRUE(skew.Refuse("DEPLOY", Seconds(200.0), Seconds(1020.0)));
  EXPECT_TRUE(skew.Refuse("DEPLOY", Seconds(1050.0), Seconds(1020.0)));
}

TEST(MailSkew, HearsEverythingWhereAnySkewIsRight) {
  MailSkew skew(std::nullopt);
  EXPECT_FALSE(skew.Refuse("DEPLOY", Seconds(0.0), Seconds(1e9)));
}

}  // namespace
}  // namespace limpet
