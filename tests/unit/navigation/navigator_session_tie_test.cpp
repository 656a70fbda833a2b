// SPDX-License-Identifier: MIT
// Two sessions over the same two objects. GPS is wrong in this one; the former one knew better.
#include <algorithm>

#include <gtest/gtest.h>

#include "estimation/navigation/navigator.hpp"
#include "limpet/core/camera_model.hpp"

namespace limpet {
namespace {

constexpr double kGpsError = 0.6;  // [m] east, all along
constexpr double kStep = 0.05;     // [s]

constexpr double kRadius = 0.5;  // [m]

struct Sphere {
  Eigen::Vector3d ned;
  std::string color;
};
const std::vector<Sphere> kSpheres{{{6.0, 0.4, 6.5}, "yellow"}, {{12.0, -0.5, 6.8}, "orange"}};

/// Both objects, where they are, each known to 0.3 m.
FormerSession KnownBefore() {
  FormerSession former;
  for (const Sphere& sphere : kSpheres) {
    former.ids.push_back(static_cast<int>(former.ids.size()) + 1);
    former.objects.push_back(
        {.p_W = sphere.ned, .cov_W = 0.09 * Eigen::Matrix3d::Identity(), .color = sphere.color});
  }
  return former;
}

class SessionTieTest : public ::testing::Test {
 protected:
  /// North, gently up to a speed, 4 m above the seabed, with or without GPS.
  void Go(double wanted_speed, double seconds, bool has_gps) {
    for (const double end = t_ + seconds; t_ < end; t_ += kStep, ++steps_) {
      speed_ += std::clamp(wanted_speed - speed_, -0.1 * kStep, 0.1 * kStep);
      navigator_.AddAttitude({.t = t_});
      navigator_.AddDepth(t_, 3.5);
      if (steps_ % 4 == 0) {
        navigator_.AddVelocity(t_, Eigen::Vector3d(speed_, 0.0, 0.0));
        navigator_.AddAltitude(t_, 4.0 - 0.18);
      }
      if (has_gps && steps_ % 20 == 0) {
        navigator_.AddGps(t_, {north_, kGpsError}, 0.4);
      }
      if (!has_gps && steps_ % 5 == 0) {
        Look();
      }
      navigator_.Advance(t_);
      north_ += speed_ * kStep;
    }
  }
  /// A frame with each object whose centre is well inside the image.
  void Look() {
    const CameraModel camera;
    Detections frame;
    frame.frame = ++frames_;
    frame.exposure = Seconds(t_);
    for (const Sphere& sphere : kSpheres) {
      const Eigen::Vector3d p_C = camera.InCamera({{north_, 0.0, 3.5}, 0.0, 0.0, 0.0}, sphere.ned);
      const auto pixel = camera.Project(p_C);
      if (pixel && (*pixel - Eigen::Vector2d(320.0, 240.0)).cwiseAbs().maxCoeff() < 180.0) {
        const double width = 2.0 * kRadius * camera.fx / p_C.z();
        const double height = 2.0 * kRadius * camera.fy / p_C.z();
        frame.boxes.push_back({pixel->x(), pixel->y(), width, height, 0.9, sphere.color});
      }
    }
    navigator_.AddFrame(frame);
  }
  /// Fixes, a dive over both objects, fixes.
  void Survey() {
    Go(0.0, 60.0, true);
    Go(0.5, 40.0, false);
    Go(0.0, 110.0, false);
    Go(0.0, 60.0, true);
  }
  [[nodiscard]] double WorstError() const {
    double worst = navigator_.Landmarks().size() == kSpheres.size() ? 0.0 : 99.0;
    for (const Landmark& landmark : navigator_.Landmarks()) {
      double nearest = 99.0;
      for (const Sphere& sphere : kSpheres) {
        nearest = std::min(nearest, (landmark.object.p_W - sphere.ned).norm());
      }
      worst = std::max(worst, nearest);
    }
    return worst;
  }

  Navigator navigator_{NavigatorParams{}};
  double t_ = 0.0, north_ = 0.0, speed_ = 0.0;
  int steps_ = 0, frames_ = 0;
};

TEST_F(SessionTieTest, WithoutAFormerSessionObjectsAreWhereGpsPutsThem) {
  Survey();
  EXPECT_NEAR(WorstError(), kGpsError, 0.15);
}

TEST_F(SessionTieTest, AFormerSessionHalvesTheError) {
  navigator_.SetFormerSession(KnownBefore());
  Survey();
  EXPECT_LT(WorstError(), 0.7 * kGpsError);
}

TEST_F(SessionTieTest, OneObjectThatStayedIsNotEnoughToTieTo) {
  FormerSession former = KnownBefore();
  former.ids.pop_back();
  former.objects.pop_back();
  navigator_.SetFormerSession(former);
  Survey();
  EXPECT_NEAR(WorstError(), kGpsError, 0.15);
}

}  // namespace
}  // namespace limpet
