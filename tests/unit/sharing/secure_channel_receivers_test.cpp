// SPDX-License-Identifier: MIT
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "limpet/sharing/secure_channel.hpp"

namespace limpet {
namespace {

TEST(ShareReceivers, ACommunityStandsForItsPShareAndNoTwoNamesForOne) {
  EXPECT_EQ(ShareNodeName("shore"), "shore/pShare");
  EXPECT_EQ(ShareNodeName("shore/pOther"), "shore/pOther");
  EXPECT_EQ(ShareReceiverId("shore"), ShareReceiverId("shore/pShare"));
  std::set<std::uint64_t> ids;
  for (int i = 0; i < 2000; ++i)
    EXPECT_TRUE(ids.insert(ShareReceiverId("vehicle_" + std::to_string(i))).second);
  EXPECT_FALSE(ids.contains(0)) << "zero is for questions and answers";
}

}  // namespace
}  // namespace limpet
