// SPDX-License-Identifier: MIT
#include "limpet/tuning/live_setting.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(LiveSetting, ReadsTheCountOfUpdatesFromAWholeSummary) {
  const std::string summary =
      "iter=7,utc_time=1.50,ofnum=3,halted=false,modes=MODE@ACTIVE,active_bhvs=cover$2.00$1$0$0$3/4"
      "$1:follow$2.00$100$0$0$0/0$1,running_bhvs=none,idle_bhvs=hold$1.00$1/2";
  EXPECT_EQ(UpdateCountIn(summary, "cover"), (UpdateCount{3, 4}));
  EXPECT_EQ(UpdateCountIn(summary, "hold"), (UpdateCount{1, 2}));
  EXPECT_FALSE(UpdateCountIn(summary, "cove"));
  EXPECT_FALSE(UpdateCountIn("", "cover"));
  EXPECT_FALSE(UpdateCountIn("idle_bhvs=cover$x$1/y", "cover"));
}

TEST(LiveSetting, AddressesOneBehaviorAndReadsItBack) {
  const std::string mail = UpdateText("cover", "frontier_weight", "0.3");
  EXPECT_EQ(mail, "name=cover#frontier_weight=0.3");
  EXPECT_EQ(UpdatedValue(mail, "cover", "FRONTIER_WEIGHT"), "0.3");
  EXPECT_FALSE(UpdatedValue(mail, "other", "frontier_weight"));
  EXPECT_FALSE(UpdatedValue(mail, "cover", "pwt"));
  EXPECT_EQ(UpdatedValue("pwt = 5 # x = 1", "cover", "x"), "1");
}

TEST(LiveEvent, ComesBackFromItsTextAndFromNoOther) {
  const LiveEvent event{.user = "ann",
                        .host = "boat",
                        .is_undo = false,
                        .is_applied = true,
                        .change = {"cover", "pwt", "1", "2"},
                        .undoable = {{"cover", "pwt", "1", "2"}}};
  const auto back = LiveEvent::FromText(event.Text());
  ASSERT_TRUE(back);
  EXPECT_EQ(back->Text(), event.Text());
  EXPECT_EQ(back->undoable.at(0).old_value, "1");
  for (const char* wrong : {"", "{}", "[]", "{\"user\": 1}", "true"}) {
    EXPECT_FALSE(LiveEvent::FromText(wrong)) << wrong;
  }
}

TEST(LiveEvent, CountsOnlyWhatTheHelmHasApplied) {
  const LiveChange to_2{"wp", "speed", "1", "2"}, to_minus_1{"wp", "speed", "2", "-1"};
  LiveEvent event;
  event.change = to_minus_1;
  event.undoable = {to_2};
  EXPECT_EQ(event.InForce("wp", "speed"), "2");
  EXPECT_TRUE(event.WasRefused("wp", "speed", "-1"));
  EXPECT_FALSE(event.WasRefused("wp", "speed", "2"));
  EXPECT_FALSE(event.InForce("wp", "pwt"));
  event.is_undo = true;
  event.change = {"wp", "speed", "3", "-1"};
  event.undoable = {to_2, to_minus_1};
  event.DropRefusedUndo();
  ASSERT_EQ(event.undoable.size(), 1U);
  EXPECT_EQ(event.InForce("wp", "speed"), "3");
  EXPECT_EQ(event.undoable.front().new_value, "3") << "the next undo leads from there";
  event = {};
  event.is_undo = event.is_applied = true;
  event.change = {"wp", "speed", "2", "1"};
  EXPECT_EQ(event.InForce("wp", "Speed"), "1") << "taken back";
  EXPECT_FALSE(event.WasRefused("wp", "speed", "1"));
}

}  // namespace
}  // namespace limpet
