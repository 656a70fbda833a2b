// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "limpet/core/params.hpp"
#include "limpet/detectors/blob_finder.hpp"
#include "limpet/detectors/color_planes.hpp"
#include "limpet/vision/detector.hpp"
#include "limpet/vision/ellipse.hpp"
#include "limpet/vision/outline_refiner.hpp"

namespace limpet {

/// Coloured balls by what sets them apart from the water around them: regions of a reduced image
/// that stand out in an opponent colour at any level (so haze, which scales contrasts, does not
/// matter), full ellipses among them, then the outline at full resolution. The class follows the
/// direction of the colour contrast. Learns nothing.
class ColorShapeDetector final : public Detector {
 public:
  struct Params {
    double least_radius_px = 8.0;
    double least_confidence = 0.30;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("least_radius_px", least_radius_px, "Objects whose image is smaller are not sought",
            InRange(2.0, 1000.0));
      visit("least_confidence", least_confidence, "Boxes below are taken for nothing",
            InRange(0.0, 1.0));
    }
  };

  explicit ColorShapeDetector(const Params& params);
  [[nodiscard]] std::vector<Box> Detect(const ImageView& image) override;

 private:
  struct Candidate {
    Ellipse ellipse;  ///< pixels of the full image
    PixelRect rect;
    double quality = 0.0;
  };
  struct Finding {
    RefinedOutline outline;  ///< pixels of the full image
    Contrast contrast;
    int factor = 1;  ///< full resolution over the one it was found at

    /// Distance of edges from the ellipse [px] at which nothing speaks for a ball any more.
    [[nodiscard]] double AllowedWobble() const {
      const double radius = outline.ellipse.MeanRadius();
      return std::min(0.10 * radius, 1.3 + 0.4 * factor + 0.01 * radius);
    }
  };
  void Shrink(const ImageView& image);
  void CollectCandidates();
  [[nodiscard]] bool Assess(const Blob& blob, Candidate& candidate) const;
  [[nodiscard]] std::optional<Finding> Refine(const ImageView& image, const Ellipse& guess) const;
  [[nodiscard]] std::optional<Box> Verify(const ImageView& image, const Candidate& candidate) const;

  Params params_;
  int factor_ = 4;  ///< full over least resolution
  cv::Mat half_;
  cv::Mat small_;
  ColorPlanes colors_;
  BlobFinder finder_;
  std::vector<Blob> blobs_;
  std::vector<Candidate> candidates_;
};

}  // namespace limpet
