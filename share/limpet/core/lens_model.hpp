// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/interval.hpp"

namespace limpet {

/// What a lens does to the image of a pinhole: radial k1, k2, k3 and tangential p1, p2 of Brown's
/// model, in the order and with the signs that OpenCV and MRPT's TCamera have them.
struct LensDistortion {
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;

  [[nodiscard]] bool is_none() const {
    return k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0 && k3 == 0.0;
  }
  /// Where a direction, as its place on the pinhole's image at unit depth, comes to lie.
  [[nodiscard]] Eigen::Vector2d Applied(const Eigen::Vector2d& pinhole) const;
  /// The direction that lies there; nothing where the lens folds the image.
  [[nodiscard]] std::optional<Eigen::Vector2d> Removed(const Eigen::Vector2d& image) const;
};

/// A camera with a lens that distorts, and the pinhole cameras of the same place, direction and
/// focal length that stand for it. All pixels in and out are those of an image, its upper left
/// corner the origin.
class LensModel {
 public:
  /// `image`: the image as it comes, its intrinsics those without the distortion. REQUIRES:
  /// IsOneToOne(image, distortion).
  LensModel(const CameraModel& image, const LensDistortion& distortion);
  /// No two directions come to lie in one pixel of the image.
  [[nodiscard]] static bool IsOneToOne(const CameraModel& image, const LensDistortion& distortion);

  [[nodiscard]] bool is_pinhole() const { return distortion_.is_none(); }
  [[nodiscard]] const CameraModel& image() const { return image_; }
  [[nodiscard]] const LensDistortion& distortion() const { return distortion_; }
  /// Shows nothing that the image does not: upright, and within it. What estimates, maps and plans
  /// works with this one.
  [[nodiscard]] const CameraModel& rectified() const { return rectified_; }
  /// Shows all that the image does.
  [[nodiscard]] const CameraModel& enclosing() const { return enclosing_; }

  /// Pixel of the image to pixel of a pinhole camera of this lens; REQUIRES: it is in the image.
  [[nodiscard]] Eigen::Vector2d ToPinhole(const CameraModel& pinhole,
                                          const Eigen::Vector2d& pixel) const;
  /// Pixel of a pinhole camera of this lens to pixel of the image; it may lie outside the image.
  [[nodiscard]] Eigen::Vector2d FromPinhole(const CameraModel& pinhole,
                                            const Eigen::Vector2d& pixel) const;

 private:
  [[nodiscard]] CameraModel Framed(const Interval& u_px, const Interval& v_px) const;

  CameraModel image_;
  LensDistortion distortion_;
  CameraModel rectified_, enclosing_;
};

}  // namespace limpet
