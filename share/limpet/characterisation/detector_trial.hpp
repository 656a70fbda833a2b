// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limpet/imaging/solid.hpp"
#include "limpet/objects/pixel_rect.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/vision/detector.hpp"
#include "limpet/vision/image.hpp"
#include "limpet/vision/sphere_box.hpp"

namespace limpet {

/// One thing in one rendered picture, and what a detector made of it.
struct TrialLook {
  SolidKind kind = SolidKind::kSphere;
  std::string color;
  double range = 0.0;  ///< [m]
  double visibility_m = 0.0;
  double size_px = 0.0;           ///< geometric mean of its outline's sides
  double visible_fraction = 0.0;  ///< of its outline, inside the image and not hidden
  PixelRect visible{};
  std::optional<Box> found;

  [[nodiscard]] double range_share() const { return range / visibility_m; }
};

struct TrialResult {
  int pictures = 0;
  int false_boxes = 0;  ///< at nothing that was put there
  std::vector<TrialLook> looks;
};

/// Worlds drawn at random: seabed, water, light, camera; balls and things of other forms.
struct TrialPlan {
  int worlds = 40;
  int pictures_per_world = 20;
  double least_visibility_m = 2.5;
  double most_visibility_m = 15.0;
  /// Colours that balls and other things have; names of `color_table.hpp`, not empty.
  std::vector<std::string> colors{"yellow", "orange", "red", "green", "white", "blue"};
  std::uint64_t seed = 1;
};

/// A picture of such a world, and what is in it; `found` is empty everywhere.
struct TrialPicture {
  Image image;
  std::vector<TrialLook> looks;
};

/// Hands each picture to `take`, rendered with the real look; `progress` as for RunTrial.
void MakeTrialPictures(const TrialPlan& plan, const std::function<void(const TrialPicture&)>& take,
                       const std::function<void(int)>& progress);

/// Renders with the real look and runs the detector. `progress` is told after each world how many
/// are done; it may be empty. Equal plans give equal results.
[[nodiscard]] TrialResult RunTrial(const TrialPlan& plan, Detector& detector,
                                   const std::function<void(int)>& progress);

}  // namespace limpet
