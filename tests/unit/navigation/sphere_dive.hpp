// SPDX-License-Identifier: MIT
// A vehicle dives north over spheres, with fixes before and after.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "estimation/navigation/navigator.hpp"
#include "limpet/core/camera_model.hpp"

namespace limpet {

struct SeabedSphere {
  Eigen::Vector3d ned;
  std::string color;
};

class SphereDive {
 public:
  explicit SphereDive(std::vector<SeabedSphere> spheres) : spheres_(std::move(spheres)) {}

  /// North, gently up to a speed, 4 m above the seabed: with GPS, or under water and looking.
  void Go(double wanted_speed, double seconds, bool has_gps) {
    for (const double end = t_ + seconds; t_ < end; t_ += kStep, ++steps_) {
      speed_ += std::clamp(wanted_speed - speed_, -0.1 * kStep, 0.1 * kStep);
      navigator_.AddAttitude({.t = t_});
      navigator_.AddDepth(t_, Meters(3.5));
      if (steps_ % 4 == 0) {
        navigator_.AddVelocity(t_, Eigen::Vector3d(speed_, velocity_error_ * speed_, 0.0));
        navigator_.AddAltitude(t_, Meters(4.0 - 0.18));
      }
      if (has_gps && steps_ % 20 == 0) {
        navigator_.AddGps(t_, {north_, gps_error_}, 0.4);
      }
      if (!has_gps && steps_ % 5 == 0) {
        Look();
      }
      navigator_.Advance(t_);
      north_ += speed_ * kStep;
    }
  }
  /// Of the landmark that is furthest from any sphere; much if there are more or less of them.
  [[nodiscard]] double WorstError() const {
    double worst = navigator_.Landmarks().size() == spheres_.size() ? 0.0 : 99.0;
    for (const Landmark& landmark : navigator_.Landmarks()) {
      double nearest = 99.0;
      for (const SeabedSphere& sphere : spheres_)
        nearest = std::min(nearest, (landmark.object.p_W - sphere.ned).norm());
      worst = std::max(worst, nearest);
    }
    return worst;
  }
  [[nodiscard]] Navigator& navigator() { return navigator_; }

  double gps_error_ = 0.0;       ///< east, all along [m]
  double velocity_error_ = 0.0;  ///< to starboard, as a share of the speed

 private:
  static constexpr double kStep = 0.05;   // [s]
  static constexpr double kRadius = 0.5;  // [m]

  /// A frame with each sphere whose centre is well inside the image.
  void Look() {
    const CameraModel camera;
    Detections frame;
    frame.frame = ++frames_;
    frame.exposure = Seconds(t_);
    for (const SeabedSphere& sphere : spheres_) {
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

  std::vector<SeabedSphere> spheres_;
  Navigator navigator_{NavigatorParams{}};
  double t_ = 0.0, north_ = 0.0, speed_ = 0.0;
  int steps_ = 0, frames_ = 0;
};

}  // namespace limpet
