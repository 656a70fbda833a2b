// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/detectors/ball_outline.hpp"
#include "limpet/detectors/blob_finder.hpp"
#include "limpet/detectors/color_planes.hpp"
#include "limpet/vision/detector.hpp"
#include "limpet/vision/ellipse.hpp"

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
  void CollectCandidates();
  [[nodiscard]] bool Assess(const Blob& blob, Candidate& candidate) const;
  [[nodiscard]] std::optional<Box> Verify(const ImageView& image, const Candidate& candidate) const;

  Params params_;
  BallOutlines outlines_;
  ColorPlanes colors_;
  BlobFinder finder_;
  std::vector<Blob> blobs_;
  std::vector<Candidate> candidates_;
};

}  // namespace limpet
