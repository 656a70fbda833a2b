// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "limpet/core/camera_model.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Cells of a grid, bounds inclusive; empty when a minimum exceeds its maximum.
struct CellBox {
  int row_min = 0, row_max = -1;
  int column_min = 0, column_max = -1;
};

/// The four side planes of the camera's view in W. A point p is inside side i when
/// normal_i . (p - apex) >= 0, and an object's centre is well inside when that is >= inset_i.
class ViewCone {
 public:
  /// `disc_inset` [m], horizontal for a level camera, is how far inside the image an object's
  /// centre must be.
  ViewCone(const Pose& X_WB, const CameraModel& camera, double disc_inset);

  /// Greatest height above the seabed point `p_W` at which an object's centre would be well inside
  /// the image, at least 0; nothing if the seabed point itself is outside the image, or if the
  /// camera is tilted so far that seeing high does not imply seeing low.
  [[nodiscard]] std::optional<double> SeenHeight(const Eigen::Vector3d& p_W) const;

  /// How far an object's centre at `height` above the seabed point `p_W` is inside the nearest side
  /// of the image, horizontally for a level camera [m]; negative outside. `as_object`: it must be
  /// `disc_inset` inside, as an object must, a point of the seabed need not.
  [[nodiscard]] double Inside(const Eigen::Vector3d& p_W, double height, bool as_object) const;
  /// The image is drawn in by so much on every side [m]: what lies there no longer counts as seen.
  void DrawIn(double by) { drawn_in_ = by; }

  /// Cells that can be inside the image of a seabed at NED depth `seabed_down` [m], with slack for
  /// relief of a tenth of the altitude.
  [[nodiscard]] CellBox CellsBelow(const GridFrame& frame, double seabed_down) const;

 private:
  Eigen::Vector3d apex_;
  std::array<Eigen::Vector3d, 4> normals_;  ///< scaled so that a level camera's are (.., tan)
  std::array<Eigen::Vector3d, 4> corners_;  ///< directions of the image's corners
  double inset_;
  double drawn_in_ = 0.0;
  bool looks_down_ = true;
};

}  // namespace limpet
