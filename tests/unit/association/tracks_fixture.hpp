// SPDX-License-Identifier: MIT
// A chain of known poses over spheres, and tracks made by hand of the boxes that they see.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/association/frame_associator.hpp"
#include "estimation/association/landmark_terms.hpp"
#include "estimation/association/track_placement.hpp"
#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "tests/unit/association/association_draws.hpp"

namespace limpet {

/// Poses are 3 m above the spheres' depth, one second apart.
class TracksFixture : public ::testing::Test {
 protected:
  static constexpr double kDepth = 6.0;  // of all spheres [m]

  /// Appends a pose, `sigma` uncertain against the one before [m].
  int FlyTo(double north, double east, double sigma = 0.01) {
    NavVector x = NavVector::Zero();
    x.head<3>() << north, east, kDepth - 3.0;
    const int node = static_cast<int>(truth_.size());
    if (node == 0) {
      smoother_.AddNode(x, std::nullopt);
      smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(x, NavVector::Constant(0.01))));
    } else {
      const Eigen::Vector3d d = x.head<3>() - truth_.back().head<3>();
      const Eigen::Vector4d variance(sigma * sigma, sigma * sigma, 1e-4, 1e-8);
      smoother_.AddNode(
          x, Term::OnStep(XyzYawFactor(Eigen::Vector4d(d.x(), d.y(), d.z(), 0.0), variance)));
    }
    smoother_.AddTerm(node, Term::OnPose(DepthFactor(Meters(x(kNavZ)), Meters(0.02))));
    smoother_.AddTerm(node,
                      Term::OnPose(RollPitchFactor(Radians(0.0), Radians(0.0), Radians(0.005))));
    truth_.push_back(x);
    tracks_.now = node;
    smoother_.Update();
    return node;
  }
  /// Three poses about a place.
  std::vector<int> FlyOver(const Eigen::Vector3d& p_W, double sigma = 0.01) {
    std::vector<int> nodes;
    for (const double ahead : {-0.5, 0.0, 0.5})
      nodes.push_back(FlyTo(p_W.x() + ahead, p_W.y(), ahead < -0.4 ? sigma : 0.01));
    return nodes;
  }
  [[nodiscard]] Observation See(const Eigen::Vector3d& p_W, int node,
                                double confidence = 0.85) const {
    Box box = *BoxFrom(camera_, truth_[static_cast<std::size_t>(node)], p_W);
    box.confidence = confidence;
    Observation one = ObservationOf(box, camera_, node, node);
    one.detection = next_detection_++;
    return one;
  }
  /// A tentative track of what those poses see of a sphere there.
  TrackedObject& Track(const Eigen::Vector3d& p_W, const std::vector<int>& nodes,
                       double confidence = 0.85) {
    TrackedObject object;
    for (const int node : nodes)
      object.observations.Add(See(p_W, node, confidence));
    object.sightings.hits = object.sightings.expected = static_cast<int>(nodes.size());
    object.sightings.max_distance = 4.0;
    Place(object, smoother_, mount_, params_.model);
    tracks_.objects.push_back(std::move(object));
    return tracks_.objects.back();
  }
  /// A track of the smoother, as of its next update.
  TrackedObject& Mapped(const Eigen::Vector3d& p_W, const std::vector<int>& nodes,
                        const TrackState& as) {
    terms_.Map(Track(p_W, nodes), as);
    Solve();
    return tracks_.objects.back();
  }
  void Solve() {
    smoother_.Update();
    for (TrackedObject& object : tracks_.objects) {
      if (object.is_mapped()) object.p_W = smoother_.BorderAt(object.slot());
    }
  }
  [[nodiscard]] NavVector Newest() const {
    return smoother_.PoseAt(static_cast<int>(truth_.size()) - 1);
  }
  [[nodiscard]] std::size_t CountLandmarks() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(tracks_.objects, &TrackedObject::is_landmark));
  }
  /// Boxes that any track has; a box that two have counts as a failure.
  [[nodiscard]] std::size_t CountBoxes() const {
    std::set<int> boxes;
    for (const TrackedObject& object : tracks_.objects) {
      for (const Observation& one : object.observations)
        EXPECT_TRUE(boxes.insert(one.detection).second) << "a box of two tracks";
    }
    return boxes.size();
  }

  const CameraModel camera_{};
  CameraMount mount_{camera_};
  ObjectTrackerParams params_;
  ArrowSmoother smoother_;
  TrackList tracks_;
  LandmarkTerms terms_{smoother_, mount_, params_, tracks_};
  std::vector<NavVector> truth_;

 private:
  mutable int next_detection_ = 0;
};

}  // namespace limpet
