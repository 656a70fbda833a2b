// SPDX-License-Identifier: MIT
// What is said of a landmark that may be a former object with some chance: between what it
// says when it is decided one way and the other.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/object_statuses.hpp"

namespace limpet {
namespace {

constexpr int kFormer = 7;
const CameraModel kDownCamera;

ObjectEstimate YellowAt(double north, double east) {
  return {
      .p_W = {north, east, 6.0}, .cov_W = 0.04 * Eigen::Matrix3d::Identity(), .color = "yellow"};
}

std::array<double, 4> Parts(const StatusPosterior& posterior) {
  return {posterior.confirmed, posterior.removed, posterior.appeared, posterior.nothing};
}

/// A flight north between a former object's place, where nothing is seen now, and a landmark that
/// may be that object with `chance`.
std::vector<OpiBelief> AssessedWith(double chance) {
  ObjectStatuses statuses(StatusParams{}, kDownCamera);
  const ObjectEstimate seen = YellowAt(4.0, 1.2);
  FormerViews views{.frames = {},
                    .model = {.look = {.camera = kDownCamera, .detection = {}}},
                    .looks = {},
                    .water = VisibilityBelief::Of({Meters(12.0), Meters(4.0)})};
  double time = 0.0;
  for (double north = -4.0; north <= 12.0; north += 0.25, time += 0.5) {
    const Pose X_WB{{north, 0.5, 3.0}, 0.0, 0.0, 0.0};
    views.frames.push_back({.exposure = Seconds(time), .X_WB = X_WB});
    ObservedFrame frame{.exposure = Seconds(100.0 + time), .X_WB = X_WB};
    if (VisibleShare(kDownCamera, X_WB, seen.p_W, 0.5) >= 0.5) {
      const Eigen::Vector2d pixel = *kDownCamera.Project(kDownCamera.InCamera(X_WB, seen.p_W));
      frame.boxes.push_back({.u = pixel.x(),
                             .v = pixel.y(),
                             .w = 120,
                             .h = 120,
                             .confidence = 0.9,
                             .color = seen.color,
                             .landmark = 1});
    }
    statuses.AddFrame(std::move(frame));
  }
  statuses.SetFormer(
      {{.id = kFormer, .object = YellowAt(4.0, -0.5), .log_likelihood_ratio = 8.0, .looks = 5}});
  statuses.SetFormerViews(std::move(views));
  Landmark landmark{.id = 1, .object = seen, .detections = 9};
  if (chance > 0.0) landmark.former.candidates = {{.id = kFormer, .probability = chance}};
  statuses.SetLandmarks({landmark});
  return statuses.Assess();
}

/// Of the landmark's own entry.
StatusPosterior LandmarkWith(double chance) { return AssessedWith(chance).back().posterior; }
/// Of the former object's entry.
StatusPosterior FormerWith(double chance) { return AssessedWith(chance).front().posterior; }

class StatusMixture : public ::testing::TestWithParam<double> {};

TEST_P(StatusMixture, IsAPosterior) {
  for (const StatusPosterior& posterior : {LandmarkWith(GetParam()), FormerWith(GetParam())}) {
    const std::array<double, 4> parts = Parts(posterior);
    EXPECT_NEAR(parts[0] + parts[1] + parts[2] + parts[3], 1.0, 1e-9);
    EXPECT_GE(*std::ranges::min_element(parts), 0.0);
  }
}

TEST_P(StatusMixture, OfTheLandmarkLiesOnTheLineBetweenBothDecisions) {
  const std::array<double, 4> another = Parts(LandmarkWith(0.0));
  const std::array<double, 4> same = Parts(LandmarkWith(1.0));
  const std::array<double, 4> mixed = Parts(LandmarkWith(GetParam()));
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    EXPECT_NEAR(mixed[i], (1.0 - GetParam()) * another[i] + GetParam() * same[i], 1e-9);
  }
}

TEST_P(StatusMixture, IsNoSurerThanTheChanceAllows) {
  const double most = std::max(GetParam(), 1.0 - GetParam()) + 0.02;
  EXPECT_LT(LandmarkWith(GetParam()).confirmed, most);
  EXPECT_LT(LandmarkWith(GetParam()).appeared, most);
  EXPECT_LT(FormerWith(GetParam()).confirmed, most);
  EXPECT_LT(FormerWith(GetParam()).removed, most);
}

TEST_P(StatusMixture, SaysConfirmedAndRemovedOfTheFormerObjectByTheChance) {
  const StatusPosterior posterior = FormerWith(GetParam());
  EXPECT_NEAR(posterior.confirmed, GetParam(), 0.05);
  EXPECT_NEAR(posterior.removed, 1.0 - GetParam(), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Chances, StatusMixture, ::testing::Values(0.05, 0.25, 0.5, 0.75, 0.94));

}  // namespace
}  // namespace limpet
