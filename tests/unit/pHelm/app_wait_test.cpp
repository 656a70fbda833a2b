// SPDX-License-Identifier: MIT
#include "apps/pHelm/app_wait.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(AppWait, IsOverOnceEachAppWasThereAtSomeTime) {
  AppWait wait({"pObstacleMgr, pTaskManager", "pContactMgr"});
  EXPECT_FALSE(wait.is_over());
  EXPECT_EQ(wait.MissingText(), "pContactMgr, pObstacleMgr, pTaskManager");
  wait.Hear("pNav, pTaskManager ,pHelm");
  wait.Hear("pNav,pObstacleMgr");
  EXPECT_EQ(wait.MissingText(), "pContactMgr");
  wait.Hear("pContactMgr");
  EXPECT_TRUE(wait.is_over());
  EXPECT_TRUE(AppWait({}).is_over());
}

}  // namespace
}  // namespace limpet
