// SPDX-License-Identifier: MIT
#include "limpet/app/warning_board.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

const WarningFamily kLost = DeclareWarningFamily("LOST_<PART>", {.severity = Severity::kWarning,
                                                                 .raised_by = {"pBoard"},
                                                                 .meaning = "A part is lost.",
                                                                 .action = "Find it.",
                                                                 .clears = "When it is found."});
constexpr Seconds kNow(1000.0);

TEST(WarningBoard, TellsAtOnceWhatIsRaisedAndCleared) {
  WarningBoard board;
  EXPECT_FALSE(board.TakeNews(kNow));
  EXPECT_EQ(board.Raise(kLost.Of("A"), "it is gone", kNow), WarningBoard::Change::kRaised);
  EXPECT_EQ(board.TakeNews(kNow), "LOST_A (warning): it is gone");
  EXPECT_TRUE(board.Clear(kLost.Of("A")));
  EXPECT_EQ(board.TakeNews(kNow), "none");
  EXPECT_FALSE(board.Clear(kLost.Of("A")));
  EXPECT_FALSE(board.TakeNews(kNow));
}

TEST(WarningBoard, HasNoNewsInWhatIsRaisedAgain) {
  WarningBoard board;
  board.Raise(kLost.Of("A"), "it is gone", kNow);
  static_cast<void>(board.TakeNews(kNow));
  EXPECT_EQ(board.Raise(kLost.Of("A"), "it is gone", kNow + Seconds(60.0)),
            WarningBoard::Change::kNone);
  EXPECT_FALSE(board.TakeNews(kNow + Seconds(60.0)));
}

TEST(WarningBoard, ATextThatFollowsIsToldOncePerPeriodOfRealTime) {
  WarningBoard board(10.0);
  board.Raise(kLost.Of("A"), "1", kNow);
  static_cast<void>(board.TakeNews(kNow));
  EXPECT_EQ(board.Raise(kLost.Of("A"), "2", kNow + Seconds(1.0)), WarningBoard::Change::kText);
  EXPECT_FALSE(board.TakeNews(kNow + Seconds(19.0)));
  EXPECT_EQ(board.TakeNews(kNow + Seconds(20.0)), "LOST_A (warning): 2");
  EXPECT_EQ(board.standing().at("LOST_A").since, kNow);
}

TEST(WarningBoard, ANewWarningTakesTheLatestTextsWithIt) {
  WarningBoard board;
  board.Raise(kLost.Of("A"), "1", kNow);
  static_cast<void>(board.TakeNews(kNow));
  board.Raise(kLost.Of("A"), "2", kNow);
  board.Raise(kLost.Of("B"), "1", kNow);
  EXPECT_EQ(board.TakeNews(kNow), "LOST_A (warning): 2; LOST_B (warning): 1");
  EXPECT_FALSE(board.TakeNews(kNow + Seconds(60.0)));
}

}  // namespace
}  // namespace limpet
