// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/detectors/color_shape_detector.hpp"
#include "limpet/detectors/network_detector.hpp"
#include "limpet/vision/detector.hpp"

namespace limpet {

/// What two witnesses say of one object.
struct WitnessedProposal {
  NetworkProposal network;    ///< its box is the one to be reported
  std::optional<Box> shape;   ///< that of `color_shape` there, if it has one
  bool is_of_network = true;  ///< else the network was asked about a box of `color_shape`
};

/// Balls by two detectors that fail in different ways: the network rarely takes structure for a
/// ball, outlines rarely miss one in plain water. What either sees both are asked about, and how
/// far it is believed follows from what each says (WitnessWeights).
class CombinedDetector final : public Detector {
 public:
  struct Params {
    std::string network = "balls.yaml";
    double least_radius_px = 8.0;
    double least_confidence = 0.30;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("network", network,
            "Description of the network: a file, or one of those in share/networks");
      visit("least_radius_px", least_radius_px,
            "Objects whose image is smaller are not sought by their outline", InRange(2.0, 1000.0));
      visit("least_confidence", least_confidence, "Boxes below are taken for nothing",
            InRange(0.0, 1.0));
    }
  };

  /// Throws ConfigError if the network cannot be read, or was not calibrated with `color_shape`.
  explicit CombinedDetector(const Params& params);

  [[nodiscard]] std::vector<Box> Detect(const ImageView& image) override;
  /// Everything that either sees, whatever its confidence.
  [[nodiscard]] std::vector<WitnessedProposal> Propose(const ImageView& image);

 private:
  Params params_;
  NetworkDetector network_;
  ColorShapeDetector shape_;
};

/// Log-odds that a box is right, less WitnessWeights' own constant: what its weights weigh.
struct WitnessFeatures {
  double score = 0.0, color = 0.0, roundness = 0.0, shape_found = 0.0, shape = 0.0;
};
[[nodiscard]] WitnessFeatures FeaturesOf(const WitnessedProposal& proposal);

}  // namespace limpet
