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
constexpr Seconds kStart(1000.0);

TEST(WarningBoard, TellsAtOnceWhatIsRaisedAndCleared) {
  WarningBoard board;
  EXPECT_FALSE(board.TakeNews(kStart));
  EXPECT_EQ(board.Raise(kLost.Of("A"), "it is gone", kStart), WarningBoard::Change::kRaised);
  EXPECT_EQ(board.TakeNews(kStart), "LOST_A (warning): it is gone");
  EXPECT_TRUE(board.Clear(kLost.Of("A")));
  EXPECT_EQ(board.TakeNews(kStart), "none");
  EXPECT_FALSE(board.Clear(kLost.Of("A")));
  EXPECT_FALSE(board.TakeNews(kStart));
}

TEST(WarningBoard, HasNoNewsInWhatIsRaisedAgain) {
  WarningBoard board;
  board.Raise(kLost.Of("A"), "it is gone", kStart);
  static_cast<void>(board.TakeNews(kStart));
  EXPECT_EQ(board.Raise(kLost.Of("A"), "it is gone", kStart + Seconds(60.0)),
            WarningBoard::Change::kNone);
  EXPECT_FALSE(board.TakeNews(kStart + Seconds(60.0)));
}

TEST(WarningBoard, ATextThatFollowsIsToldOncePerPeriodOfRealTime) {
  WarningBoard board(10.0);
  board.Raise(kLost.Of("A"), "1", kStart);
  static_cast<void>(board.TakeNews(kStart));
  EXPECT_EQ(board.Raise(kLost.Of("A"), "2", kStart + Seconds(1.0)), WarningBoard::Change::kText);
  EXPECT_FALSE(board.TakeNews(kStart + Seconds(19.0)));
  EXPECT_EQ(board.TakeNews(kStart + Seconds(20.0)), "LOST_A (warning): 2");
  EXPECT_EQ(board.standing().at("LOST_A").since, kStart);
}

TEST(WarningBoard, ANewWarningTakesTheLatestTextsWithIt) {
  WarningBoard board;
  board.Raise(kLost.Of("A"), "1", kStart);
  static_cast<void>(board.TakeNews(kStart));
  board.Raise(kLost.Of("A"), "2", kStart);
  board.Raise(kLost.Of("B"), "1", kStart);
  EXPECT_EQ(board.TakeNews(kStart), "LOST_A (warning): 2; LOST_B (warning): 1");
  EXPECT_FALSE(board.TakeNews(kStart + Seconds(60.0)));
}

}  // namespace
}  // namespace limpet
