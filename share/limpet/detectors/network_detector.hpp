// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "limpet/core/params.hpp"
#include "limpet/detectors/ball_outline.hpp"
#include "limpet/detectors/network_cells.hpp"
#include "limpet/detectors/network_description.hpp"
#include "limpet/vision/detector.hpp"

namespace limpet {

/// What the network says of one object, and what its outline says to that.
struct NetworkProposal {
  Box box;                   ///< along the outline if there is one; without a confidence
  double score_logit = 0.0;  ///< that an object with about this box is there
  double color_logit = 0.0;  ///< that it has its colour, against all others
  double roundness = 0.0;    ///< of the outline at the network's box, 0 if there is none
};

/// Balls by a convolutional network that looks at the whole image once: every cell of 8 pixels says
/// whether an object's middle lies in it, and how large and of which colour it is. Learned on
/// pictures that no camera took (training/detector), run by OpenCV. Where an outline is near the
/// network's box, the box is the outline's, to a fraction of a pixel.
class NetworkDetector final : public Detector {
 public:
  struct Params {
    std::string network = "balls.yaml";
    double least_confidence = 0.30;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("network", network,
            "Description of the network: a file, or one of those in share/networks");
      visit("least_confidence", least_confidence, "Boxes below are taken for nothing",
            InRange(0.0, 1.0));
    }
  };

  /// Throws ConfigError if the network cannot be read.
  explicit NetworkDetector(const Params& params);
  ~NetworkDetector() override;
  NetworkDetector(const NetworkDetector&) = delete;
  NetworkDetector& operator=(const NetworkDetector&) = delete;
  NetworkDetector(NetworkDetector&&) = delete;
  NetworkDetector& operator=(NetworkDetector&&) = delete;

  [[nodiscard]] std::vector<Box> Detect(const ImageView& image) override;
  /// Everything that may be something, whatever its confidence, best score first.
  [[nodiscard]] std::vector<NetworkProposal> Propose(const ImageView& image);
  /// What network and outline say of a box that another detector has found in the image that was
  /// last proposed from; the box stays as it is, its colour too.
  [[nodiscard]] NetworkProposal Weigh(const ImageView& image, const Box& box) const;
  [[nodiscard]] const NetworkDescription& description() const { return description_; }

 private:
  struct Net;
  [[nodiscard]] double ConfidenceOf(const NetworkProposal& proposal) const;
  [[nodiscard]] cv::Size InputSize(const ImageView& image) const;
  void FollowOutline(const ImageView& image, NetworkProposal& proposal) const;

  Params params_;
  NetworkDescription description_;
  std::unique_ptr<Net> net_;
  cv::Mat reduced_;
  BallOutlines outlines_;
};

}  // namespace limpet
