// SPDX-License-Identifier: MIT
#include "estimation/mapping/object_layer.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const CameraModel kCamera;
constexpr double kRadius = 0.5;

Box BoxAround(const Pose& X_WB, const Eigen::Vector3d& p_W, int landmark) {
  const Eigen::Vector3d p_C = kCamera.InCamera(X_WB, p_W);
  const Eigen::Vector2d pixel = *kCamera.Project(p_C);
  return {.u = pixel.x(),
          .v = pixel.y(),
          .w = 2.0 * kRadius * kCamera.fx / p_C.z(),
          .h = 2.0 * kRadius * kCamera.fy / p_C.z(),
          .confidence = 0.9,
          .color = "yellow",
          .landmark = landmark};
}

OpiBelief StatusAt(const Eigen::Vector3d& ned, Status decided, std::optional<int> landmark = 1) {
  OpiBelief status;
  status.id = 1;
  status.landmark = landmark;
  if (!landmark) status.former_id = 7;
  status.object.p_W = ned;
  status.posterior.appeared = 0.98;
  status.posterior.nothing = 0.02;
  status.decided = decided;
  return status;
}

/// Flies north over `ned` and paints what it sees.
struct Flight {
  StatusParams status;
  ObjectStatuses statuses{status, kCamera};
  SemanticMap map;
  ObjectLayer layer{{}, status, kCamera};

  explicit Flight(const Eigen::Vector3d& ned) {
    statuses.SetLandmarks({{.id = 1, .object = {.p_W = ned, .color = "yellow"}, .detections = 5}});
    for (int i = 0; i < 20; ++i) {
      const Pose X_WB{{ned.x() - 1.2 + 0.125 * i, ned.y() + 0.4, ned.z() - 3.0}, 0.02, -0.01, 0.0};
      statuses.AddFrame(
          {.exposure = Seconds(0.25 * i), .X_WB = X_WB, .boxes = {BoxAround(X_WB, ned, 1)}});
    }
  }
  [[nodiscard]] std::optional<VoxelBelief> At(const Eigen::Vector3d& p_W) const {
    return map.At(KeyOf(p_W, map.resolution()));
  }
  void Paint(const OpiBelief& object) { layer.SetObjects({object}, statuses, map); }
};

const Eigen::Vector3d kPlace(4.07, 1.02, 5.53);

TEST(ObjectProbability, IsTheConfidenceAtTheCentreAndNeverEvidenceAgainst) {
  EXPECT_NEAR(ObjectProbability({0.0, 50.0}, 0.9), 0.9, 1e-12);
  EXPECT_NEAR(ObjectProbability({50.0, 50.0}, 0.9), 0.5 + 0.4 * std::exp(-0.5), 1e-12);
  EXPECT_GE(ObjectProbability({1e4, 50.0}, 0.9), 0.5);
}

TEST(NearSurface, LiesOnTheSphereAndFacesTheCamera) {
  const Pose X_WB{{4.0, 1.5, 2.5}, 0.0, 0.0, 0.3};
  const ObjectLook look{.X_WB = X_WB, .box = BoxAround(X_WB, kPlace, 1), .object_W = kPlace};
  const std::vector<VoxelEvidence> points =
      NearSurface(look, kCamera, {.radius = kRadius, .spacing = 0.1});
  EXPECT_GT(points.size(), 50U);
  for (const VoxelEvidence& point : points) {
    EXPECT_NEAR((point.p_W - kPlace).norm(), kRadius, 0.02);
    EXPECT_LT((point.p_W - X_WB.p_WB).norm(), (kPlace - X_WB.p_WB).norm());
    EXPECT_GE(point.log_odds, 0.0);
  }
}

TEST(NearSurface, GivesTheRadiusOfTheSphereInTheBox) {
  const Pose X_WB{{4.0, 1.5, 2.5}, 0.0, 0.0, 0.3};
  const ObjectLook look{.X_WB = X_WB, .box = BoxAround(X_WB, kPlace, 1), .object_W = kPlace};
  EXPECT_NEAR(RadiusFromBox(look, kCamera), kRadius, 0.01);
}

/// Neither cut to a smaller sphere nor painted with gaps.
TEST(NearSurface, ShowsAnObjectOfEightMetresAcross) {
  constexpr double kLarge = 4.0;
  constexpr double kSpacing = 0.1;
  const Pose X_WB{{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0};
  const Eigen::Vector3d centre(0.0, 0.0, 14.0);
  ObjectLook look{.X_WB = X_WB, .box = BoxAround(X_WB, centre, 1), .object_W = centre};
  look.box.w *= kLarge / kRadius;
  look.box.h *= kLarge / kRadius;
  EXPECT_NEAR(RadiusFromBox(look, kCamera), kLarge, 0.01);
  const std::vector<VoxelEvidence> points =
      NearSurface(look, kCamera, {.radius = kLarge, .spacing = kSpacing});
  const double disc = kLarge * kLarge * 3.14159;
  EXPECT_GT(static_cast<double>(points.size()), 0.7 * disc / (kSpacing * kSpacing));
}

TEST(SphereCentre, FindsTheCentreFromTheUpperCapAlone) {
  std::vector<Eigen::Vector3d> points;
  for (double tilt = 0.1; tilt < 1.2; tilt += 0.2) {
    for (double turn = 0.0; turn < 6.2; turn += 0.5) {
      points.emplace_back(kPlace + kRadius * Eigen::Vector3d(std::sin(tilt) * std::cos(turn),
                                                             std::sin(tilt) * std::sin(turn),
                                                             -std::cos(tilt)));
    }
  }
  const std::optional<Eigen::Vector3d> centre = SphereCentre(points, kRadius);
  ASSERT_TRUE(centre);
  EXPECT_LT((*centre - kPlace).norm(), 1e-3);
}

TEST(SphereCentre, NeedsFourPoints) { EXPECT_FALSE(SphereCentre({kPlace}, kRadius)); }

TEST(ObjectLayer, FindsTheSpheresCentreFromItsVoxels) {
  Flight flight(kPlace);
  flight.Paint(StatusAt(kPlace, Status::kNew));
  const std::optional<ObjectCluster> cluster = flight.layer.Cluster(1);
  ASSERT_TRUE(cluster);
  EXPECT_GT(cluster->voxels, 15);
  EXPECT_LT((cluster->centre_W - kPlace).norm(), 0.15);
}

TEST(ObjectLayer, TakesTheVoxelsAlongWhenTheLandmarkMoves) {
  Flight flight(kPlace);
  flight.Paint(StatusAt(kPlace, Status::kNew));
  const Eigen::Vector3d moved = kPlace + Eigen::Vector3d(0.6, -0.4, 0.2);
  flight.Paint(StatusAt(moved, Status::kNew));
  EXPECT_LT((flight.layer.Cluster(1)->centre_W - moved).norm(), 0.15);
  EXPECT_FALSE(flight.At(kPlace - Eigen::Vector3d(0.45, 0, 0.2)));
}

TEST(ObjectLayer, LabelsVoxelsWithTheirObjectsStatus) {
  Flight flight(kPlace);
  flight.Paint(StatusAt(kPlace, Status::kConfirmed));
  const auto top = flight.At(kPlace - Eigen::Vector3d(0, 0, 0.45));
  ASSERT_TRUE(top);
  EXPECT_EQ(top->label, VoxelLabel::kConfirmed);
  EXPECT_GT(top->object, std::log(0.7 / 0.3));
  EXPECT_GT(top->exists, 3.0F);
}

/// Neither what is gone nor what this session has not seen stands in its map.
TEST(ObjectLayer, PaintsNoFormerObjectThatNoLookShowed) {
  const Eigen::Vector3d top_W = kPlace - Eigen::Vector3d(0, 0, 0.45);
  for (const Status status : {Status::kRemoved, Status::kNotInspected, Status::kUncertain}) {
    Flight flight(kPlace);
    flight.Paint(StatusAt(kPlace, status, std::nullopt));
    EXPECT_FALSE(flight.At(top_W)) << NameOf(status);
    EXPECT_FALSE(flight.layer.Cluster(1)) << NameOf(status);
  }
}

TEST(ObjectLayer, WhatTurnsOutToBeGoneLeavesTheMap) {
  Flight flight(kPlace);
  flight.Paint(StatusAt(kPlace, Status::kConfirmed));
  flight.Paint(StatusAt(kPlace, Status::kRemoved, std::nullopt));
  EXPECT_FALSE(flight.At(kPlace - Eigen::Vector3d(0, 0, 0.45)));
}

TEST(ObjectLayer, ForgetsAnObjectThatIsNoMore) {
  Flight flight(kPlace);
  flight.Paint(StatusAt(kPlace, Status::kNew));
  flight.layer.SetObjects({}, flight.statuses, flight.map);
  EXPECT_FALSE(flight.layer.Cluster(1));
  EXPECT_FALSE(flight.At(kPlace - Eigen::Vector3d(0, 0, 0.45)));
}

/// What the detector reports of a box that reaches over the image's border.
Box Clipped(Box box) {
  const auto clip = [](double& centre, double& size, double image) {
    const double low = std::max(centre - 0.5 * size, 0.0);
    const double high = std::min(centre + 0.5 * size, image);
    centre = 0.5 * (low + high), size = high - low;
  };
  clip(box.u, box.w, kCamera.width_px);
  clip(box.v, box.h, kCamera.height_px);
  return box;
}

/// Flies north past `ned` with the object at the image's edge in every frame.
Flight PastTheEdge(const Eigen::Vector3d& ned, int landmark) {
  Flight flight(ned);
  flight.statuses = ObjectStatuses(flight.status, kCamera);
  const double beside = 3.0 * kCamera.half_across() - 0.1;
  for (int i = 0; i < 20; ++i) {
    const Pose X_WB{{ned.x() - 1.2 + 0.125 * i, ned.y() - beside, ned.z() - 3.0}, 0.0, 0.0, 0.0};
    flight.statuses.AddFrame({.exposure = Seconds(0.25 * i),
                              .X_WB = X_WB,
                              .boxes = {Clipped(BoxAround(X_WB, ned, landmark))}});
  }
  flight.statuses.SetLandmarks(
      {{.id = 1, .object = {.p_W = ned, .color = "yellow"}, .detections = 5}});
  return flight;
}

TEST(WholeBox, IsTheOneBeyondTheBorder) {
  const Pose X_WB{{4.0, 1.5, 2.5}, 0.0, 0.0, 0.0};
  for (const Eigen::Vector3d& beside : {Eigen::Vector3d(0.3, 2.4, 3.0), {1.7, 0.2, 3.0}}) {
    const Box box = BoxAround(X_WB, X_WB.p_WB + beside, 1);
    const Box mended = WholeBox(Clipped(box), {50.0, 50.0}, kCamera);
    EXPECT_LT(box.w, box.h * 1.2);
    EXPECT_NEAR(mended.u, box.u, 1.0);
    EXPECT_NEAR(mended.v, box.v, 1.0);
    EXPECT_NEAR(mended.w, box.w, 2.0);
    EXPECT_NEAR(mended.h, box.h, 2.0);
  }
}

TEST(WholeBox, OfACornerHasTheObjectsSize) {
  const Pose X_WB{{4.0, 1.5, 2.5}, 0.0, 0.0, 0.0};
  const Box box = BoxAround(X_WB, X_WB.p_WB + Eigen::Vector3d(1.7, 2.4, 3.0), 1);
  const Box mended = WholeBox(Clipped(box), {0.5 * box.w, 0.5 * box.h}, kCamera);
  EXPECT_NEAR(mended.u, box.u, 1.0);
  EXPECT_NEAR(mended.v, box.v, 1.0);
}

TEST(NearSurface, ShowsNothingOutsideTheImage) {
  const Pose X_WB{{4.0, 1.5, 2.5}, 0.0, 0.0, 0.0};
  const Eigen::Vector3d p_W = X_WB.p_WB + Eigen::Vector3d(0.0, 2.4, 3.0);
  const ObjectLook look{.X_WB = X_WB, .box = BoxAround(X_WB, p_W, 1), .object_W = p_W};
  for (const VoxelEvidence& point :
       NearSurface(look, kCamera, {.radius = kRadius, .spacing = 0.1})) {
    EXPECT_LE(kCamera.Project(kCamera.InCamera(X_WB, point.p_W))->x(), kCamera.width_px + 1e-6);
  }
}

TEST(ObjectLayer, PaintsAnObjectThatOnlyTheImagesEdgeShowed) {
  Flight flight = PastTheEdge(kPlace, 1);
  flight.Paint(StatusAt(kPlace, Status::kNew));
  const std::optional<ObjectCluster> cluster = flight.layer.Cluster(1);
  ASSERT_TRUE(cluster);
  EXPECT_LT((cluster->centre_W - kPlace).norm(), 0.25);
}

TEST(ObjectLayer, PaintsFromFramesOfBeforeTheSmootherKnewTheObject) {
  Flight flight = PastTheEdge(kPlace, -1);
  flight.Paint(StatusAt(kPlace, Status::kNew));
  EXPECT_TRUE(flight.layer.Cluster(1));
}

TEST(ObjectLayer, HoldsNothingAgainstAnObjectThatWasFirstThoughtElsewhere) {
  Flight flight(kPlace);
  const Eigen::Vector3d elsewhere = kPlace + Eigen::Vector3d(6.0, 0.0, 0.0);
  for (int i = 0; i < 8; ++i) {
    const Pose over{elsewhere + Eigen::Vector3d(0.6 * (i - 4), 0.0, -3.0), 0.0, 0.0, 0.0};
    flight.statuses.AddFrame({.exposure = Seconds(100.0 + 0.25 * i), .X_WB = over});
  }
  flight.Paint(StatusAt(elsewhere, Status::kNew));
  flight.Paint(StatusAt(kPlace, Status::kNew));
  EXPECT_TRUE(flight.layer.Cluster(1));
}

TEST(ObjectCluster, OfOneVoxelIsAsUncertainAsThatVoxelIsLarge) {
  const std::optional<ObjectCluster> cluster =
      LargestCluster({{1, 2, 3}}, {.radius = kRadius, .spacing = 0.2});
  ASSERT_TRUE(cluster);
  EXPECT_NEAR(cluster->deviation_W.x(), 0.2 / std::sqrt(12.0), 1e-9);
}

TEST(ObjectLayer, OnePassThatMissesDoesNotUndoAnObject) {
  Flight flight(kPlace);
  for (int i = 0; i < 20; ++i) {
    const Pose beside{kPlace + Eigen::Vector3d(0.125 * (i - 10), 0.0, -3.0), 0.0, 0.0, 0.0};
    flight.statuses.AddFrame({.exposure = Seconds(100.0 + 0.25 * i), .X_WB = beside});
  }
  flight.Paint(StatusAt(kPlace, Status::kNew));
  EXPECT_TRUE(flight.layer.Cluster(1));
}

TEST(ObjectLayer, LooksThatMissMakeVoxelsLessCertain) {
  Flight flight(kPlace);
  flight.Paint(StatusAt(kPlace, Status::kNew));
  const float before = flight.At(kPlace - Eigen::Vector3d(0, 0, 0.45))->object;
  // Pass after pass: one miss alone is lost in the clamp of a sure voxel.
  for (int i = 0; i < 8; ++i) {
    const Pose beside{kPlace + Eigen::Vector3d(0.6 * (i - 4), 0.0, -3.0), 0.0, 0.0, 0.0};
    flight.statuses.AddFrame({.exposure = Seconds(100.0 + 30.0 * i), .X_WB = beside});
    flight.layer.AddFrame(flight.statuses.frames().back(), flight.statuses);
  }
  flight.Paint(StatusAt(kPlace, Status::kNew));
  EXPECT_LT(flight.At(kPlace - Eigen::Vector3d(0, 0, 0.45))->object, before);
}

/// In murk a frame without a box says nothing of an object: the map must not deny what the verdicts
/// confirm.
TEST(ObjectLayer, HoldsNothingAgainstAnObjectThatTheWaterHid) {
  const Eigen::Vector3d top_W = kPlace - Eigen::Vector3d(0, 0, 0.45);
  Flight flight(kPlace);
  flight.Paint(StatusAt(kPlace, Status::kConfirmed));
  const float seen = flight.At(top_W)->object;
  for (int i = 0; i < 8; ++i) {
    const Pose over{kPlace + Eigen::Vector3d(0.6 * (i - 4), 0.0, -3.0), 0.0, 0.0, 0.0};
    flight.statuses.AddFrame({.exposure = Seconds(100.0 + 30.0 * i), .X_WB = over});
    flight.layer.AddFrame(flight.statuses.frames().back(), flight.statuses);
  }
  flight.Paint(StatusAt(kPlace, Status::kConfirmed));
  ASSERT_LT(flight.At(top_W)->object, seen) << "the water was taken for clear";
  DetectionModel murk = flight.status.detection;
  murk.visibility = Meters(1.2);
  flight.layer.SetDetection(murk);
  flight.Paint(StatusAt(kPlace, Status::kConfirmed));
  EXPECT_FLOAT_EQ(flight.At(top_W)->object, seen);
}

}  // namespace
}  // namespace limpet
