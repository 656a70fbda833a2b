// SPDX-License-Identifier: MIT
#include "estimation/change/merged_landmarks.hpp"

#include <optional>
#include <vector>

#include <gmock/gmock.h>

namespace limpet {
namespace {

using namespace literals;

Landmark SeenAt(int id, double north, int detections) {
  Landmark landmark{.id = id, .object = {}, .detections = detections};
  landmark.object.p_W.x() = north;
  return landmark;
}
std::vector<int> Ids(const MergedLandmarks& landmarks) {
  std::vector<int> ids;
  for (const Landmark& object : landmarks.objects()) {
    ids.push_back(object.id);
  }
  return ids;
}

TEST(MergedLandmarks, WhoWasDetectedMostOftenStandsForItsNeighbours) {
  MergedLandmarks landmarks(1.0_m);
  landmarks.Set({SeenAt(1, 0.0, 3), SeenAt(2, 0.6, 9), SeenAt(3, 1.2, 4), SeenAt(4, 5.0, 1)});
  EXPECT_THAT(Ids(landmarks), testing::ElementsAre(2, 4));
  EXPECT_EQ(landmarks.Representative(1), 2);
  EXPECT_EQ(landmarks.Representative(3), 2);
  EXPECT_EQ(landmarks.Representative(4), 4);
  EXPECT_EQ(landmarks.Representative(5), std::nullopt);
  EXPECT_EQ(landmarks.Representative(std::nullopt), std::nullopt);
}

TEST(MergedLandmarks, TheOrderInWhichLandmarksComeMakesNoDifference) {
  MergedLandmarks one(1.0_m), other(1.0_m);
  one.Set({SeenAt(1, 0.0, 3), SeenAt(2, 0.6, 3), SeenAt(3, 1.2, 3)});
  other.Set({SeenAt(3, 1.2, 3), SeenAt(1, 0.0, 3), SeenAt(2, 0.6, 3)});
  EXPECT_EQ(Ids(one), Ids(other));
  EXPECT_EQ(one.representatives(), other.representatives());
}

TEST(MergedLandmarks, WhatAFrameShowsSideBySideStaysTwo) {
  MergedLandmarks landmarks(1.0_m);
  ObservedFrame frame;
  frame.boxes.resize(3);
  frame.boxes[0].landmark = 2, frame.boxes[2].landmark = 1;
  landmarks.NoteSeenTogether(frame);
  landmarks.Set({SeenAt(1, 0.0, 3), SeenAt(2, 0.6, 9)});
  EXPECT_THAT(Ids(landmarks), testing::ElementsAre(1, 2));
}

TEST(MergedLandmarks, TwoFormerObjectsAreTwoAndAMatchOutlivesAMerger) {
  MergedLandmarks landmarks(1.0_m);
  Landmark former = SeenAt(1, 0.0, 3), another = SeenAt(2, 0.6, 9);
  former.former.id = 11;
  landmarks.Set({former, another});
  ASSERT_THAT(Ids(landmarks), testing::ElementsAre(2));
  EXPECT_EQ(landmarks.objects()[0].former.id, 11);

  another.former.id = 12;
  landmarks.Set({former, another});
  EXPECT_THAT(Ids(landmarks), testing::ElementsAre(1, 2));
}

TEST(MergedLandmarks, SaysWhetherOthersStandForObjectsThanBefore) {
  MergedLandmarks landmarks(1.0_m);
  EXPECT_TRUE(landmarks.Set({SeenAt(1, 0.0, 3)}));
  EXPECT_FALSE(landmarks.Set({SeenAt(1, 0.2, 4)}));
  EXPECT_TRUE(landmarks.Set({SeenAt(1, 0.2, 4), SeenAt(2, 0.4, 1)}));
  EXPECT_TRUE(landmarks.Set({SeenAt(1, 0.2, 4), SeenAt(2, 0.4, 7)}));
  EXPECT_TRUE(landmarks.Set({}));
}

}  // namespace
}  // namespace limpet
