// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "estimation/navigation/motion_comparison.hpp"
#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// How boxes move through the images, beside how the seabed that they show would by the camera's
/// mounting and the vehicle's way: a camera that hangs upside down, or a mirrored image, makes
/// objects that no two boxes agree on, so none is ever found. Only classes with one box in two
/// images in a row tell, if it moves about as far as it should: others may be of two things.
class BoxMotion {
 public:
  explicit BoxMotion(const CameraModel& camera);

  /// An image whose boxes below `least_confidence` do not count, from a pose in any frame that
  /// stays for seconds, so high above the seabed.
  void Add(const Detections& frame, const Pose& X_DB, Meters altitude, double least_confidence);
  /// What says that the mounting is another than believed, by all of the last stretches alike;
  /// nothing if it is not, or not known yet.
  [[nodiscard]] std::optional<MotionComparison::Ratio> Disagreement() const;

 private:
  /// Middle of the only box of each class [px]; nothing where there are several.
  using Middles = std::map<std::string, std::optional<Eigen::Vector2d>>;
  struct View {
    double t = 0.0;  ///< [s]
    Pose X_DB;
    double altitude = 0.0;
    Middles middles_px;
  };
  [[nodiscard]] Middles MiddlesOf(const Detections& frame, double least_confidence) const;
  /// Where the seabed that `last_` showed at a pixel is in the image from `X_DB`.
  [[nodiscard]] std::optional<Eigen::Vector2d> SeenFrom(const Pose& X_DB,
                                                        const Eigen::Vector2d& at_px) const;

  CameraModel camera_;
  std::optional<View> last_;
  MotionComparison comparison_;
};

}  // namespace limpet
