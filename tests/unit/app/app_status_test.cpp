// SPDX-License-Identifier: MIT
#include "limpet/app/app_status.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::MatchesRegex;

TEST(AppStatus, IsWrittenAsMoosAppsWriteIt) {
  LiveLink link({.host = "127.0.0.1",
                 .port = 1,
                 .name = "pNav",
                 .warp = 1.0,
                 .on_mail = nullptr,
                 .on_state = nullptr});
  link.Publish("NAV_Y", 1.0, "");
  link.Publish("NAV_X", 1.0, "");
  link.Subscribe("GPS_DATA", Seconds(0.0));
  AppStatus status("pNav", link.Now());
  EXPECT_EQ(status.variable(), "PNAV_STATUS");
  EXPECT_THAT(status.Text(42, link),
              MatchesRegex("AppErrorFlag=false,Uptime=[0-9.]+,cpuload=[0-9.e+-]+,memory_kb=[0-9]+,"
                           "memory_max_kb=[0-9]+,Iterations=42,MOOSName=pNav,"
                           "Publishing=\"NAV_X,NAV_Y,\",Subscribing=\"GPS_DATA,\""));
}

TEST(UseOfThisProcess, KnowsItsMemoryAndTime) {
  const ProcessUse use = UseOfThisProcess();
  EXPECT_GT(use.memory_kb, 1000);
  EXPECT_GE(use.memory_max_kb, use.memory_kb / 2);
  EXPECT_GE(use.cpu, Seconds(0.0));
}

}  // namespace
}  // namespace limpet
