// SPDX-License-Identifier: MIT
#include "estimation/change/tentative_objects.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const WatchModel kModel{};
const ObservedFrame kSight{
    .exposure = Seconds(0.0), .X_WB = {{10.0, 20.0, 3.5}, 0, 0, 0}, .altitude = 4.0};

/// The box of a sphere of 0.5 m at body offset (forward, starboard) and 2.5 m below, cut at the
/// image's border.
Box BoxAt(double forward, double starboard) {
  const CameraModel& camera = kModel.look.camera;
  const double depth = 2.5;
  const auto clip = [](double x, int extent) {
    return std::clamp(x, 0.0, static_cast<double>(extent));
  };
  const double u = camera.cx + camera.fx * starboard / depth;
  const double v = camera.cy - camera.fy * forward / depth;
  const double left = clip(u - camera.fx * 0.5 / depth, camera.width_px);
  const double right = clip(u + camera.fx * 0.5 / depth, camera.width_px);
  const double top = clip(v - camera.fy * 0.5 / depth, camera.height_px);
  const double bottom = clip(v + camera.fy * 0.5 / depth, camera.height_px);
  return {.u = 0.5 * (left + right),
          .v = 0.5 * (top + bottom),
          .w = right - left,
          .h = bottom - top,
          .confidence = 0.9,
          .color = "yellow"};
}

TEST(PlaceOfBox, IsWhereTheObjectIs) {
  const auto place = PlaceOfBox(BoxAt(0.3, -0.8), kSight, kModel);
  ASSERT_TRUE(place);
  EXPECT_LT((*place - Eigen::Vector3d(10.3, 19.2, 6.0)).norm(), 1e-6);
}

TEST(PlaceOfBox, IsAlsoFoundWhenOneBorderCutsTheBox) {
  for (const double starboard : {-2.0, 2.0}) {
    const auto place = PlaceOfBox(BoxAt(0.3, starboard), kSight, kModel);
    ASSERT_TRUE(place);
    EXPECT_LT((*place - Eigen::Vector3d(10.3, 20.0 + starboard, 6.0)).norm(), 1e-6);
  }
}

TEST(PlaceOfBox, IsUnknownInACorner) { EXPECT_FALSE(PlaceOfBox(BoxAt(1.4, 2.0), kSight, kModel)); }

TEST(PlaceOfBox, IsNotBelowTheSeabed) {
  Box small = BoxAt(0.0, 0.0);
  small.w = small.h = 40.0;
  EXPECT_FALSE(PlaceOfBox(small, kSight, kModel));
}

bool Nothing(const ObservedFrame&, const Box&) { return false; }

/// Flies north past an object that is `starboard` of the track; every frame has its box.
void FlyPast(TentativeObjects& tentative, double starboard, bool has_box, double start = 0.0) {
  for (int i = 0; i < 24; ++i) {
    const double forward = 1.5 - 0.125 * i;
    ObservedFrame frame{.exposure = Seconds(start + 0.25 * i),
                        .X_WB = {{10.0 - forward, 20.0 - starboard, 3.5}, 0, 0, 0},
                        .altitude = 4.0};
    if (has_box) frame.boxes = {BoxAt(forward, starboard)};
    tentative.AddFrame(frame, kModel, Nothing);
  }
}
/// Time goes by elsewhere.
void FlyElsewhere(TentativeObjects& tentative, double time) {
  tentative.AddFrame({.exposure = Seconds(time), .X_WB = {{90.0, 90.0, 3.5}, 0, 0, 0}}, kModel,
                     Nothing);
}

TEST(TentativeObjects, TakesCutBoxesThatAgreeForATentativeObject) {
  TentativeObjects tentative;
  FlyPast(tentative, 2.0, true);
  FlyElsewhere(tentative, 10.0);
  ASSERT_EQ(tentative.Open().size(), 1U);
  EXPECT_LT((tentative.Open()[0]->place.p_W - Eigen::Vector3d(10.0, 20.0, 6.0)).norm(), 0.3);
}

TEST(TentativeObjects, IsOverAfterAGoodLookThatShowsNothing) {
  TentativeObjects tentative;
  FlyPast(tentative, 2.0, true);
  FlyPast(tentative, 0.3, false, 60.0);
  FlyElsewhere(tentative, 70.0);
  EXPECT_TRUE(tentative.Open().empty());
}

TEST(TentativeObjects, GivesUpAPlaceThatNobodyReaches) {
  TentativeObjects tentative;
  FlyPast(tentative, 2.0, true);
  FlyElsewhere(tentative, 500.0);
  EXPECT_TRUE(tentative.Open().empty());
}

TEST(TentativeObjects, MakesNothingOfOneFalseDetection) {
  TentativeObjects tentative;
  ObservedFrame frame = kSight;
  frame.boxes = {BoxAt(0.3, 2.0)};
  tentative.AddFrame(frame, kModel, Nothing);
  FlyElsewhere(tentative, 10.0);
  EXPECT_TRUE(tentative.Open().empty());
}

}  // namespace
}  // namespace limpet
