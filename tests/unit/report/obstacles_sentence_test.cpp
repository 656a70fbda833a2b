// SPDX-License-Identifier: MIT
#include "limpet/report/obstacles_sentence.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ObstaclesSentence, SaysHowNearEachWasPassedAndWhatWasTouched) {
  SessionScore session;
  EXPECT_EQ(ObstaclesSentence(session), "");
  session.obstacles = {{.name = "pile", .distance_m = 1.62}, {.name = "wreck", .distance_m = 0.0}};
  EXPECT_EQ(ObstaclesSentence(session), "obstacles passed at: pile 1.6 m, wreck TOUCHED");
}

}  // namespace
}  // namespace limpet
