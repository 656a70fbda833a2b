// SPDX-License-Identifier: MIT
#include "limpet/report/fences_sentence.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(FencesSentence, SaysWhichFenceWasCrossedAndHowFar) {
  SessionScore session;
  EXPECT_EQ(FencesSentence(session), "") << "nobody knows the truth";
  session.fences = FenceScore{};
  EXPECT_EQ(FencesSentence(session), "");
  session.fences->inside_zone_m = 1.23;
  EXPECT_EQ(FencesSentence(session), "ENTERED A KEEP-OUT ZONE, by 1.2 m");
  session.fences->outside_region_m = 0.4;
  EXPECT_EQ(FencesSentence(session),
            "ENTERED A KEEP-OUT ZONE, by 1.2 m; LEFT ITS REGION, by 0.4 m");
}

}  // namespace
}  // namespace limpet
