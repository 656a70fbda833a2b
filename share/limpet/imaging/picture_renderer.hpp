// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"
#include "limpet/imaging/caustics.hpp"
#include "limpet/imaging/clutter.hpp"
#include "limpet/imaging/ground_view.hpp"
#include "limpet/imaging/jpeg.hpp"
#include "limpet/imaging/lamp.hpp"
#include "limpet/imaging/lens.hpp"
#include "limpet/imaging/linear_image.hpp"
#include "limpet/imaging/sensor.hpp"
#include "limpet/imaging/solid.hpp"
#include "limpet/imaging/water_column.hpp"
#include "limpet/objects/pixel_rect.hpp"
#include "limpet/simulation/image_params.hpp"
#include "limpet/vision/image.hpp"
#include "limpet/vision/scene_settings.hpp"
#include "limpet/vision/seabed_relief.hpp"

namespace limpet {

struct PictureSettings {
  SceneSettings scene;
  ImageParams image;
  double decoys_per_image = 0.0;  ///< litter in a picture from kDecoyRange, on top of the density
};

/// Where an object is in a picture: the truth that a detector is taught and judged by.
struct SolidLabel {
  std::size_t solid = 0;          ///< index among the solids given
  PixelRect outline{};            ///< of the whole silhouette, also outside the image
  PixelRect visible{};            ///< around what can be seen of it, in whole pixels
  double visible_fraction = 0.0;  ///< of its pixels in the image that nothing nearer hides
};

/// Pictures as a camera in the sea makes them: seabed, clutter and objects under sun and lamp,
/// through water, lens and sensor. Equal settings, pose, solids, frame and time give equal bytes.
/// Not thread-safe.
class PictureRenderer {
 public:
  /// `decoys_per_image` is meant for a camera so far above the seabed [m].
  static constexpr double kDecoyRange = 4.0;
  explicit PictureRenderer(const PictureSettings& settings);

  /// What the camera of a body at `X_WB` sees in frame number `frame`, taken at `time`.
  [[nodiscard]] Image Render(const Pose& X_WB, std::span<const Solid> solids, std::uint32_t frame,
                             Seconds time);
  /// Labels of the last picture, for each solid of which at least a pixel can be seen.
  [[nodiscard]] const std::vector<SolidLabel>& labels() const { return labels_; }

 private:
  void PaintSolids(const Pose& X_WB, std::span<const Solid> solids, const SceneLight& light);
  void AddLabel(SolidLabel found, std::uint8_t label, int painted_pixels);
  void AddFlakes(const SceneLight& light, std::uint32_t frame);

  PictureSettings settings_;
  WaterColumn water_;
  Lamp lamp_;
  Caustics caustics_;
  SeabedRelief relief_;
  Eigen::Vector3d towards_sun_W_;
  GroundView ground_;
  Clutter clutter_;
  Lens lens_;
  Sensor sensor_;
  Jpeg jpeg_;
  LinearImage linear_;
  std::vector<std::uint8_t> label_image_;  ///< 0: none, else 1 + place in the painting order
  std::vector<Growth> growth_;
  std::vector<Solid> litter_;
  std::vector<SolidLabel> labels_;
};

}  // namespace limpet
