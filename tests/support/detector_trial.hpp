// SPDX-License-Identifier: MIT
// Random scenes, rendered and searched: what the detector found of what was there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/objects/pixel_rect.hpp"
#include "limpet/vision/box_model.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/scene_renderer.hpp"

namespace limpet::trial {

/// One sphere in one frame. Spheres that overlap in the image are left out: who hides whom is
/// another question.
struct Look {
  SphereImage image;
  std::string color;
  double visibility_m = 0.0;
  std::optional<Box> found;

  [[nodiscard]] double range_share() const { return image.range / visibility_m; }
};

struct Result {
  int frames = 0;
  int false_boxes = 0;
  std::vector<Look> looks;
};

struct Plan {
  int scenes = 10;  ///< each with a seabed, a visibility and `frames` poses
  int frames = 20;
  double least_visibility_m = 3.0;
  double most_visibility_m = 15.0;
  std::uint64_t seed = 1;
  std::string detector = "color_shape";
};

/// A body 2 to 5 m above a bottom at 7.5 m, rolling and pitching a little.
inline Pose RandomPose(Random& random) {
  Pose pose;
  pose.p_WB = {random.Uniform(-20.0, 20.0), random.Uniform(-20.0, 20.0),
               7.5 - random.Uniform(2.0, 5.0)};
  pose.roll = random.Normal(0.04);
  pose.pitch = random.Normal(0.04);
  pose.yaw = random.Uniform(-3.1, 3.1);
  return pose;
}

/// Up to three balls around the body, half of them floating up to 2 m high.
inline std::vector<Sphere> RandomSpheres(const Pose& pose, Random& random) {
  const std::vector<std::string> colors{"yellow", "orange", "red", "green", "white", "blue"};
  const double altitude = 7.5 - pose.p_WB.z();
  std::vector<Sphere> spheres(random.Index(4));
  for (Sphere& sphere : spheres) {
    sphere.radius = random.Uniform(0.25, 0.6);
    const double highest = std::min(2.0, altitude - 1.0 - sphere.radius);
    const bool floats = random.Chance(0.5) && highest > sphere.radius;
    const double height = floats ? random.Uniform(sphere.radius, highest) : sphere.radius;
    const double ahead = 0.7 * altitude * random.Uniform(-1.0, 1.0);
    const double right = 0.95 * altitude * random.Uniform(-1.0, 1.0);
    const double cosine = std::cos(pose.yaw);
    const double sine = std::sin(pose.yaw);
    sphere.p_W = {pose.p_WB.x() + cosine * ahead - sine * right,
                  pose.p_WB.y() + sine * ahead + cosine * right, 7.5 - height};
    sphere.color = colors[random.Index(colors.size())];
  }
  return spheres;
}

/// What of the spheres is inside the image, and which box belongs to which; boxes of nothing are
/// counted, unless they lie on a sphere.
inline void Compare(const std::vector<SphereImage>& images, const std::vector<std::string>& colors,
                    const std::vector<Box>& boxes, double visibility_m, Result& result) {
  std::vector<char> is_explained(boxes.size(), 0);
  for (std::size_t i = 0; i < images.size(); ++i) {
    Look look{images[i], colors[i], visibility_m, std::nullopt};
    bool overlaps = false;
    for (std::size_t j = 0; j < images.size(); ++j) {
      overlaps |= j != i && Intersection(images[i].visible, images[j].visible).area() > 0.0;
    }
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const PixelRect rect = RectOf(boxes[b]);
      if (!look.found && Overlap(rect, images[i].visible) > 0.5) {
        look.found = boxes[b];
      }
      if (Intersection(rect, images[i].visible).area() > 0.5 * rect.area()) is_explained[b] = 1;
    }
    if (!overlaps) {
      result.looks.push_back(look);
    }
  }
  for (const char explained : is_explained) {
    result.false_boxes += explained == 0 ? 1 : 0;
  }
}

template <class Find>
Result RunScenes(const Plan& plan, Find&& find_of_scene) {
  Random random(plan.seed, "detector trial");
  const CameraModel camera;
  Result result;
  for (int scene = 0; scene < plan.scenes; ++scene) {
    const double visibility = random.Uniform(plan.least_visibility_m, plan.most_visibility_m);
    const std::uint64_t seed = random.Bits();
    auto find = find_of_scene(visibility, seed);
    for (int frame = 0; frame < plan.frames; ++frame) {
      const Pose pose = RandomPose(random);
      const std::vector<Sphere> spheres = RandomSpheres(pose, random);
      std::vector<SphereImage> images;
      std::vector<std::string> colors;
      for (const Sphere& sphere : spheres) {
        if (auto image = ImageOfSphere(camera, camera.InCamera(pose, sphere.p_W), sphere.radius)) {
          images.push_back(*image);
          colors.push_back(sphere.color);
        }
      }
      ++result.frames;
      Compare(images, colors, find(pose, spheres, frame), visibility, result);
    }
  }
  return result;
}

/// Renders and detects.
inline Result RunDetector(const Plan& plan) {
  return RunScenes(plan, [&plan](double visibility, std::uint64_t seed) {
    const double phase = static_cast<double>(seed % 1000);
    auto renderer = std::make_shared<SceneRenderer>(
        SceneSettings{.camera = {},
                      .seabed_depth =
                          [phase](const Eigen::Vector2d& p_W) {
                            return 7.5 + 0.05 * (std::sin(1.3 * p_W.x() + phase) +
                                                 std::sin(0.9 * p_W.y() + 0.4 * p_W.x()));
                          },
                      .visibility_m = visibility,
                      .seabed_seed = seed,
                      .noise_seed = seed + 1});
    const std::shared_ptr<Detector> detector = MakeDetector(plan.detector);
    return [renderer, detector](const Pose& pose, const std::vector<Sphere>& spheres, int frame) {
      const Image image = renderer->Render(pose, spheres, static_cast<std::uint32_t>(frame));
      return detector->Detect(image.view());
    };
  });
}

/// Draws from the model, on the same scenes.
inline Result RunModel(const Plan& plan, const BoxModelConstants& constants = {}) {
  return RunScenes(plan, [&constants](double visibility, std::uint64_t seed) {
    BoxModel model({.camera = {},
                    .visibility_m = visibility,
                    .false_boxes_per_image = 0.005,
                    .constants = constants});
    return
        [model, random = Random(seed)](const Pose& pose, const std::vector<Sphere>& spheres,
                                       int) mutable { return model.Detect(pose, spheres, random); };
  });
}

}  // namespace limpet::trial
