// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/vision/sphere.hpp"
#include "limpet/vision/sphere_box.hpp"

namespace limpet {

/// What ColorShapeDetector achieves on SceneRenderer's frames, as functions of the share x of the
/// visibility that the range is, and of the visible fraction f of the sphere's image. Printed by
/// tests/bench/fit_box_model; run it again after every change to the renderer or the detector.
struct BoxModelConstants {
  // P(detected) = peak * S((faint_at - x) / faint_width) * S((f - cut_at) / cut_width), S logistic.
  double peak = 0.995;
  double faint_at = 1.31;
  double faint_width = 0.07;
  double cut_at = 0.27;
  double cut_width = 0.09;
  double least_radius_px = 9.0;  ///< smaller images are not found
  // Standard deviations of centre and size [px] grow with the range and as the ball is cut.
  double centre_sd_px = 0.025;
  double size_sd_px = 0.066;
  double size_bias_px = -0.43;
  double sd_growth_faint = 37.0;  ///< factor 1 + growth * x^2
  double sd_growth_cut = 2.3;     ///< factor 1 + growth * (1 - f)
  // Confidence's mean at x = 0, f = 1, and falls linearly with x^2 and 1 - f.
  double confidence = 0.996;
  double confidence_loss_faint = 0.118;
  double confidence_loss_cut = 0.044;
  double confidence_sd = 0.03;
  // P(wrong class) for a whole and for a nearly hidden ball.
  double confusion_whole = 0.0005;
  double confusion_cut = 0.069;
};

/// Draws what a detector would report, without an image: for sweeps that cannot afford one.
class BoxModel {
 public:
  struct Settings {
    CameraModel camera;
    double visibility_m = 8.0;
    double false_boxes_per_image = 0.01;
    BoxModelConstants constants;
  };
  explicit BoxModel(const Settings& settings) : settings_(settings) {}

  /// Boxes of one frame.
  [[nodiscard]] std::vector<Box> Detect(const Pose& X_WB, std::span<const Sphere> spheres,
                                        Random& random) const;

  /// Probability that a sphere with this image is found.
  [[nodiscard]] double DetectionProbability(const SphereImage& image) const;

 private:
  [[nodiscard]] Box Draw(const SphereImage& image, const std::string& color, Random& random) const;
  [[nodiscard]] Box DrawFalse(Random& random) const;

  Settings settings_;
};

}  // namespace limpet
