// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/imaging/clutter.hpp"
#include "limpet/imaging/linear_image.hpp"
#include "limpet/imaging/scene_light.hpp"
#include "limpet/imaging/seabed_tile.hpp"
#include "limpet/imaging/tile_noise.hpp"
#include "limpet/vision/corner_grid.hpp"

namespace limpet {

/// The seabed in one camera: where its pixels look, what light falls there and what of it arrives.
class GroundView {
 public:
  GroundView(const CameraModel& camera, SeabedTile tile, std::uint64_t seed);

  /// Floats from row to row that an image needs to be painted by this.
  [[nodiscard]] std::size_t stride() const { return (corners_.columns() - 1) * kBlock; }

  /// Finds the seabed for every block's corner.
  void Look(const SceneLight& light, SeabedRelief& relief);
  [[nodiscard]] Clutter::Area area() const { return area_; }       ///< that is in view
  [[nodiscard]] double mean_range() const { return mean_range_; }  ///< [m]
  /// Darkens the seabed where `solid` takes its light.
  void DropShadow(const SceneLight& light, const Solid& solid,
                  const Eigen::Vector3d& towards_sun_W);
  /// Paints the seabed with what grows on it.
  void Paint(const CameraModel& camera, const Pose& X_WB, SeabedRelief& relief,
             std::span<const Growth> growth, const Eigen::Vector3d& towards_sun_W,
             LinearImage& image);

 private:
  static constexpr int kBlock = CornerGrid::kBlock;
  static constexpr int kCausticStep = 4;
  enum Layer { kAcross, kAlong, kSunShare, kGain, kVeil = kGain + 3, kLayers = kVeil + 3 };
  /// A growth in the image, and the pixels that it may cover.
  struct Spot {
    const Growth* growth;
    int left, right, top, bottom;
  };

  void LookAt(const SceneLight& light, SeabedRelief& relief, int column, int row, double& range);
  void FillCaustics(const SceneLight& light);
  void SampleRow();
  void PaintSpot(const Spot& spot, const Eigen::Vector3f& sun);
  void InterpolateCaustics(int row);
  void ShadeRow(int row, LinearImage& image) const;

  CameraModel camera_;
  SeabedTile tile_;
  TileNoise patches_;
  CornerGrid corners_;  ///< places are east, north less origin_ [m]
  std::size_t caustic_columns_, caustic_rows_;
  std::vector<float> caustics_;        ///< excess of light, every kCausticStep pixels
  std::vector<float> row_caustics_;    ///< of one image row
  std::vector<std::uint32_t> texels_;  ///< of one image row, as SeabedTile packs them
  std::vector<Spot> spots_;
  Eigen::Vector2d origin_;  ///< east, north [m]; corner of a tile
  Clutter::Area area_;
  double mean_range_ = 1.0;
};

}  // namespace limpet
