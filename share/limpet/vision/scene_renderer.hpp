// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/vision/corner_grid.hpp"
#include "limpet/vision/image.hpp"
#include "limpet/vision/linear_row.hpp"
#include "limpet/vision/scene_settings.hpp"
#include "limpet/vision/seabed_relief.hpp"
#include "limpet/vision/seabed_texture.hpp"
#include "limpet/vision/sphere.hpp"
#include "limpet/vision/water_optics.hpp"

namespace limpet {

/// Pictures of a rough seabed with spheres through hazy water, from a camera that looks down.
/// Equal settings, pose, spheres and frame number give equal bytes. Not thread-safe.
class SceneRenderer {
 public:
  explicit SceneRenderer(const SceneSettings& settings);

  /// What the camera of a body at `X_WB` sees in frame number `frame`. Spheres of a colour that the
  /// table lacks are grey.
  [[nodiscard]] Image Render(const Pose& X_WB, std::span<const Sphere> spheres,
                             std::uint32_t frame);

 private:
  /// Values of the grid's corners: place in the texture [1/256 texel], and per channel what is left
  /// of the seabed's light and the veil before it.
  enum Layer { kAcross, kAlong, kGain, kVeil = kGain + 3, kLayers = kVeil + 3 };
  struct View;  // of one frame

  void FillNodes(const View& view, std::span<const Sphere> spheres);
  void FillNode(const View& view, int column, int row, double& distance);
  void DropShadow(const View& view, const Sphere& sphere);
  void SampleSeabedRow(int row);
  void ShadeSeabedRow(LinearRow& linear) const;
  void AddSpecks(std::uint32_t frame, Image& image) const;
  void Develop(const LinearRow& linear, std::uint64_t counter, std::uint8_t* bgr) const;
  [[nodiscard]] float Vignette(const Eigen::Vector2d& at_px) const;

  static constexpr int kBlock = CornerGrid::kBlock;
  SceneSettings settings_;
  WaterOptics water_;
  SeabedTexture texture_;
  SeabedRelief relief_;
  CornerGrid corners_;             ///< places are north, east [m], relative to the camera
  std::vector<float> brightness_;  ///< of the seabed along one row, 0 to 255
  std::vector<std::uint8_t> tone_curve_;
  std::vector<std::int8_t> noise_;
};

}  // namespace limpet
