// SPDX-License-Identifier: MIT
#include "limpet/session/session_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SessionOrder, IsDiscoveryThenChangeThenOthersByName) {
  std::vector<std::string> sessions{"second", "change", "after", "discovery"};
  SortSessions(sessions);
  EXPECT_THAT(sessions, ::testing::ElementsAre("discovery", "change", "after", "second"));
}

}  // namespace
}  // namespace limpet
