// SPDX-License-Identifier: MIT
// Where a box stops hinting at an object, and what is believed of one that it hints at.
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/object_statuses.hpp"
#include "estimation/change/tentative_objects.hpp"

namespace limpet {
namespace {

constexpr double kBelow = 4.0;  // of the seabed [m]

ObservedFrame LookFrom(double north, double time) {
  return {.exposure = Seconds(time), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}, .altitude = kBelow};
}

/// The box in the image's middle of a sphere of 0.5 m at this depth below the camera [m].
Box BoxAtDepth(double depth) {
  const CameraModel camera;
  return {.u = camera.cx,
          .v = camera.cy,
          .w = camera.fx / depth,
          .h = camera.fy / depth,
          .confidence = 0.9,
          .color = "yellow"};
}

/// The same where the vehicle looks straight down at (north, east) = (0, 0) from `north`.
Box BoxOfOrigin(double north, double depth) {
  Box box = BoxAtDepth(depth);
  box.v += CameraModel{}.fy * north / depth;
  return box;
}

TEST(PlaceOfBoxBorders, ReachSevenTenthsOfAMetreBelowTheSeabed) {
  const WatchModel model{};
  EXPECT_TRUE(PlaceOfBox(BoxAtDepth(kBelow + 0.69), LookFrom(0.0, 0.0), model));
  EXPECT_FALSE(PlaceOfBox(BoxAtDepth(kBelow + 0.71), LookFrom(0.0, 0.0), model));
}

TEST(PlaceOfBoxBorders, ReachHalfAMetreBeforeTheCamera) {
  WatchModel model{.look = {.camera = {}, .detection = {}, .object_radius = 0.1}};
  const auto box_at = [](double depth) {
    Box box = BoxAtDepth(depth);
    box.w *= 0.2, box.h *= 0.2;  // of a sphere of 0.1 m
    return box;
  };
  EXPECT_TRUE(PlaceOfBox(box_at(0.51), LookFrom(0.0, 0.0), model));
  EXPECT_FALSE(PlaceOfBox(box_at(0.49), LookFrom(0.0, 0.0), model));
}

TEST(PlaceOfBoxBorders, WithoutAnAltitudeReachAsFarAsOneSees) {
  WatchModel model{};
  model.look.detection.visibility = Meters(3.0);
  ObservedFrame frame = LookFrom(0.0, 0.0);
  frame.altitude.reset();
  EXPECT_TRUE(PlaceOfBox(BoxAtDepth(3.69), frame, model));
  EXPECT_FALSE(PlaceOfBox(BoxAtDepth(3.71), frame, model));
}

/// What is said of boxes that no landmark explains, at (0, 0), 3 m below the vehicle.
std::vector<OpiBelief> AfterThreeBoxes(ObjectStatuses& statuses) {
  double time = 0.0;
  for (const double north : {-0.4, 0.0, 0.4}) {
    ObservedFrame frame = LookFrom(north, time += 0.25);
    frame.boxes = {BoxOfOrigin(north, 3.0)};
    statuses.AddFrame(frame);
  }
  statuses.AddFrame(LookFrom(30.0, time + 5.0));  // no box has come for a while
  return statuses.Assess();
}

TEST(TentativeObjectBelief, IsWorthALookAndNoMoreThanAHint) {
  ObjectStatuses statuses(StatusParams{}, CameraModel{});
  const std::vector<OpiBelief> objects = AfterThreeBoxes(statuses);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_LT(objects[0].object.p_W.head<2>().norm(), 0.05);
  EXPECT_NEAR(objects[0].object.p_W.z(), 6.0, 0.05);
  EXPECT_NEAR(objects[0].posterior.appeared, 0.3, 1e-12);
  EXPECT_NEAR(objects[0].posterior.nothing, 0.7, 1e-12);
  EXPECT_EQ(objects[0].decided, Status::kUncertain);
  EXPECT_NEAR(objects[0].object.cov_W(0, 0), 0.3 * 0.3, 1e-12) << "known to 0.3 m";
}

TEST(TentativeObjectBelief, IsNotHeldBesideALandmarkNearerThanAMetreAndAHalf) {
  for (const double distance : {1.45, 1.55}) {
    ObjectStatuses statuses(StatusParams{}, CameraModel{});
    static_cast<void>(AfterThreeBoxes(statuses));
    Landmark landmark;
    landmark.id = 5;
    landmark.object = {
        .p_W = {0.0, distance, 6.0}, .cov_W = 1e-4 * Eigen::Matrix3d::Identity(), .color = "green"};
    landmark.detections = 5;
    statuses.SetLandmarks({landmark});
    bool is_held = false;
    for (const OpiBelief& object : statuses.Assess())
      is_held = is_held || !object.landmark;
    EXPECT_EQ(is_held, distance > 1.5) << distance;
  }
}

}  // namespace
}  // namespace limpet
