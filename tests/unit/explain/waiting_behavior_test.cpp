// SPDX-License-Identifier: MIT
#include "limpet/explain/waiting_behavior.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> TextsAt(const WaitingBehaviors& waiting, double time) {
  std::vector<std::string> texts;
  for (const WaitingBehavior& one : waiting.At(time)) {
    texts.push_back(one.name + (one.is_done ? " done: " : ": ") + one.what);
  }
  return texts;
}

TEST(WaitingBehaviors, WaitUntilTheHelmSaysThatTheyRun) {
  WaitingBehaviors waiting;
  waiting.Take("BHV_STATUS", "name=lap,pc=DEPLOY = true,state=idle,updates=0/0", 1.0);
  waiting.Take("BHV_STATUS", "name=deep,pc=(A = 1, 2) or (B < 3),state=idle,updates=n/a", 1.0);
  waiting.Take("BHV_STATUS", "name=lap,pwt=100,state=active,updates=0/0", 5.0);
  waiting.Take("BHV_STATUS", "name=lap,pc=arrived,state=completed,updates=1/2", 9.0);
  waiting.Take("IVPHELM_STATE", "DRIVE", 9.5);
  EXPECT_THAT(TextsAt(waiting, 0.5), IsEmpty());
  EXPECT_THAT(TextsAt(waiting, 4.9),
              ElementsAre("lap: DEPLOY = true", "deep: (A = 1, 2) or (B < 3)"));
  EXPECT_THAT(TextsAt(waiting, 5.0), ElementsAre("deep: (A = 1, 2) or (B < 3)"));
  EXPECT_THAT(TextsAt(waiting, 99.0),
              ElementsAre("lap done: arrived", "deep: (A = 1, 2) or (B < 3)"));
  EXPECT_EQ(waiting.At(99.0).front().since, 9.0);
}

TEST(WaitingBehaviors, AreOthersAfterTheHelmHasBegunAnew) {
  WaitingBehaviors waiting;
  waiting.Take("BHV_STATUS", "name=lap,pc=DEPLOY = true,state=idle,updates=0/0", 1.0);
  waiting.Take("IVPHELM_RESTARTED", "true", 5.0);
  waiting.Take("BHV_STATUS", "name=home,pc=RETURN = true,state=idle,updates=n/a", 5.1);
  EXPECT_THAT(TextsAt(waiting, 6.0), ElementsAre("home: RETURN = true"));
  EXPECT_THAT(TextsAt(waiting, 4.0), ElementsAre("lap: DEPLOY = true")) << "as it was then";
}

TEST(WaitingBehaviors, LeaveWhatIsNoStatusAlone) {
  WaitingBehaviors waiting;
  for (const char* text :
       {"", "name=", "name=,state=idle", "state=idle", "name=lap", "pc=,name=x"}) {
    waiting.Take("BHV_STATUS", text, 1.0);
  }
  EXPECT_THAT(waiting.At(2.0), IsEmpty());
}

}  // namespace
}  // namespace limpet
