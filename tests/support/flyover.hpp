// SPDX-License-Identifier: MIT
// Straight flights over spheres with a perfect pose: what the camera would report.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/survey/detection_chance.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet::trial {

struct Sphere {
  Eigen::Vector3d ned = Eigen::Vector3d::Zero();
  std::string color = "yellow";
  std::optional<int> landmark{};  ///< id the smoother gave it
  double radius = 0.5;
};

/// A straight line at constant depth, 4 fps.
struct Leg {
  double north = 0.0, east = 0.0, down = 3.5, yaw = 0.0;
  double length = 10.0;
  double speed = 0.5;
  double altitude = 4.0;
};

struct Detector {
  double detects = 0.95;  ///< chance per frame of an object mostly inside the image
  double false_per_image = 0.0;
  double least_share = 0.5;
};

/// One frame from `X_WB`.
inline ObservedFrame SightFrom(const Pose& X_WB, double altitude,
                               const std::vector<Sphere>& spheres, const Detector& detector,
                               Random& random) {
  const CameraModel camera;
  ObservedFrame frame;
  frame.X_WB = X_WB;
  frame.altitude = altitude;
  for (const Sphere& sphere : spheres) {
    const double share = VisibleShare(camera, X_WB, sphere.ned, sphere.radius);
    if (share < detector.least_share || !random.Chance(detector.detects)) continue;
    const Eigen::Vector3d p_C = camera.InCamera(X_WB, sphere.ned);
    const Eigen::Vector2d pixel = *camera.Project(p_C);
    frame.boxes.push_back({.u = pixel.x(),
                           .v = pixel.y(),
                           .w = 2.0 * sphere.radius * camera.fx / p_C.z(),
                           .h = 2.0 * sphere.radius * camera.fy / p_C.z(),
                           .confidence = 0.9,
                           .color = sphere.color,
                           .landmark = sphere.landmark});
  }
  if (random.Chance(detector.false_per_image)) {
    frame.boxes.push_back({.u = random.Uniform(40, 600),
                           .v = random.Uniform(40, 440),
                           .w = 80,
                           .h = 80,
                           .confidence = 0.6,
                           .color = "yellow"});
  }
  return frame;
}

/// All frames of a leg, from `start` on.
inline std::vector<ObservedFrame> Fly(const Leg& leg, Seconds start,
                                      const std::vector<Sphere>& spheres, const Detector& detector,
                                      Random& random) {
  std::vector<ObservedFrame> frames;
  const double step = leg.speed * 0.25;
  for (int i = 0; i * step <= leg.length; ++i) {
    const Pose X_WB{{leg.north + i * step * std::cos(leg.yaw),
                     leg.east + i * step * std::sin(leg.yaw), leg.down},
                    0.0,
                    0.0,
                    leg.yaw};
    frames.push_back(SightFrom(X_WB, leg.altitude, spheres, detector, random));
    frames.back().frame = i;
    frames.back().exposure = start + Seconds(0.25 * i);
  }
  return frames;
}

}  // namespace limpet::trial
