// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/params.hpp"
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

  /// `visit(name, field, help, range)`.
  template <class V>
  void Describe(V& visit) {
    visit("box_peak", peak, "Share found of what is near, whole and large", InRange(0.0, 1.0));
    visit("box_faint_at", faint_at, "Range over the visibility where half of it is found",
          InRange(0.05, 3.0));
    visit("box_faint_width", faint_width, "Width of the fall of the share found there",
          InRange(0.001, 1.0));
    visit("box_cut_at", cut_at, "Visible fraction at which half is found", InRange(0.0, 1.0));
    visit("box_cut_width", cut_width, "Width of the fall of the share found there",
          InRange(0.001, 1.0));
    visit("box_least_radius_px", least_radius_px, "Smaller images are not found",
          InRange(0.5, 200.0));
    visit("box_centre_sd_px", centre_sd_px, "1-sigma of a near box's centre", InRange(0.0, 50.0));
    visit("box_size_sd_px", size_sd_px, "1-sigma of a near box's width and height",
          InRange(0.0, 50.0));
    visit("box_size_bias_px", size_bias_px, "Mean error of a near box's width and height",
          InRange(-50.0, 50.0));
    visit("box_sd_growth_faint", sd_growth_faint,
          "Growth of those 1-sigmas with the square of the range over the visibility",
          InRange(0.0, 1000.0));
    visit("box_sd_growth_cut", sd_growth_cut, "Growth of those 1-sigmas with the hidden fraction",
          InRange(0.0, 1000.0));
    visit("box_confidence", confidence, "Mean confidence of a near, whole object",
          InRange(0.0, 1.0));
    visit("box_confidence_loss_faint", confidence_loss_faint,
          "Confidence lost with the square of the range over the visibility", InRange(0.0, 2.0));
    visit("box_confidence_loss_cut", confidence_loss_cut,
          "Confidence lost with the hidden fraction", InRange(0.0, 2.0));
    visit("box_confidence_sd", confidence_sd, "1-sigma of the confidence", InRange(0.0, 1.0));
    visit("box_confusion_whole", confusion_whole, "Share of whole objects given a wrong class",
          InRange(0.0, 1.0));
    visit("box_confusion_cut", confusion_cut, "Share of nearly hidden objects given a wrong class",
          InRange(0.0, 1.0));
  }
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

  /// A box where nothing is, of an object's colour, anywhere in the image.
  [[nodiscard]] Box DrawFalse(Random& random) const;

 private:
  [[nodiscard]] Box Draw(const SphereImage& image, const std::string& color, Random& random) const;

  Settings settings_;
};

}  // namespace limpet
