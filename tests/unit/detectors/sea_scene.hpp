// SPDX-License-Identifier: MIT
// Balls over a seabed as a real camera would show them, and what a detector makes of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/imaging/picture_renderer.hpp"
#include "limpet/vision/detector_registry.hpp"

namespace limpet::sea_scene {

constexpr double kDepth = 7.5;

/// Its seeds are not those that detectors were taught or calibrated with.
struct SeaScene {
  SeaScene(const std::string& detector_name, const std::string& seabed, double visibility_m = 8.0)
      : detector(MakeDetector(detector_name)) {
    PictureSettings settings{
        .scene = {.camera = {}, .seabed_depth = [](const Eigen::Vector2d&) { return kDepth; }},
        .image = {}};
    settings.scene.visibility_m = visibility_m;
    settings.image.look = "real";
    settings.image.seabed.kind = seabed;
    settings.scene.seabed_seed = 77;
    renderer = std::make_unique<PictureRenderer>(settings);
  }
  Image Take(const std::vector<Solid>& solids, double altitude = 3.0) {
    Pose pose;
    pose.p_WB = {0.0, 0.0, kDepth - altitude};
    return renderer->Render(pose, solids, 0, Seconds(1.0));
  }
  std::vector<Box> Find(const std::vector<Solid>& solids, double altitude = 3.0) {
    return detector->Detect(Take(solids, altitude).view());
  }
  std::unique_ptr<PictureRenderer> renderer;
  std::unique_ptr<Detector> detector;
};

inline Solid Ball(double north, double east, double radius, const std::string& color) {
  return {.p_W = {north, east, kDepth - radius}, .radius = radius, .color = color};
}

}  // namespace limpet::sea_scene
