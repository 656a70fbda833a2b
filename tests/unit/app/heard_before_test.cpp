// SPDX-License-Identifier: MIT
#include "limpet/app/heard_before.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

Message Written(double time, std::int32_t id = 7, const std::string& source = "pNav") {
  return {.name = "NAV_X",
          .value = 1.0,
          .time = Seconds(time),
          .source = source,
          .source_aux = "",
          .community = "",
          .id = id};
}
Message Latest(double time, const std::string& source = "pNav") {
  return Written(time, -1, source);
}

TEST(HeardBefore, LeavesOutALatestValueThatWasHeardOnTheFormerConnection) {
  HeardBefore heard;
  EXPECT_TRUE(heard.IsNews(Written(10.0)));
  heard.StartConnection();
  EXPECT_FALSE(heard.IsNews(Latest(10.0)));
}

TEST(HeardBefore, LeavesOutAnOlderOne) {
  HeardBefore heard;
  EXPECT_TRUE(heard.IsNews(Written(10.0)));
  heard.StartConnection();
  EXPECT_FALSE(heard.IsNews(Latest(9.0)));
}

TEST(HeardBefore, LetsThroughWhatWasWrittenMeanwhile) {
  HeardBefore heard;
  EXPECT_TRUE(heard.IsNews(Written(10.0)));
  heard.StartConnection();
  EXPECT_TRUE(heard.IsNews(Latest(10.1)));
}

TEST(HeardBefore, LetsThroughWhatAnotherWrote) {
  HeardBefore heard;
  EXPECT_TRUE(heard.IsNews(Written(10.0)));
  heard.StartConnection();
  EXPECT_TRUE(heard.IsNews(Latest(9.0, "uPoke")));
}

TEST(HeardBefore, LetsThroughALiveMessageWhateverItsTime) {
  HeardBefore heard;
  EXPECT_TRUE(heard.IsNews(Written(10.0)));
  heard.StartConnection();
  EXPECT_TRUE(heard.IsNews(Written(9.0)));
}

TEST(HeardBefore, LetsThroughALatestValueThatIsAskedForAgain) {
  HeardBefore heard;
  EXPECT_TRUE(heard.IsNews(Latest(10.0)));
  EXPECT_TRUE(heard.IsNews(Latest(10.0)));
  heard.StartConnection();
  heard.Forget("NAV_X");
  EXPECT_TRUE(heard.IsNews(Latest(10.0)));
}

}  // namespace
}  // namespace limpet
