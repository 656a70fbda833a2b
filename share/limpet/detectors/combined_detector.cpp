// SPDX-License-Identifier: MIT
#include "limpet/detectors/combined_detector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/logistic.hpp"
#include "limpet/core/probability.hpp"
#include "limpet/objects/pixel_rect.hpp"
#include "limpet/vision/detector_registry.hpp"

namespace limpet {
namespace {

constexpr double kSameObject = 0.5;   // overlap of two boxes of one object
constexpr double kLeastShape = 0.05;  // a weak outline is a weak witness, but one
constexpr double kLeastScore = -6.0;  // a network that is surer than that of nothing is no surer
constexpr double kMostCertain = 0.98;
constexpr Interval kCredible{.low = 1.0 - kMostCertain, .high = kMostCertain};  // of an outline

double ConfidenceOf(const WitnessWeights& weights, const WitnessedProposal& proposal) {
  const WitnessFeatures features = FeaturesOf(proposal);
  const double logit =
      weights.offset + weights.per_score * features.score + weights.per_color * features.color +
      weights.per_roundness * features.roundness + weights.shape_found * features.shape_found +
      weights.per_shape * features.shape;
  return Logistic(logit);
}

}  // namespace

WitnessFeatures FeaturesOf(const WitnessedProposal& proposal) {
  const bool has_shape = proposal.shape.has_value();
  return {.score = std::max(proposal.network.score_logit, kLeastScore),
          .color = proposal.network.color_logit,
          .roundness = proposal.network.roundness,
          .shape_found = has_shape ? 1.0 : 0.0,
          .shape = has_shape ? LogOddsOf(proposal.shape->confidence, kCredible) : 0.0};
}

CombinedDetector::CombinedDetector(const Params& params)
    : params_(params),
      network_({.network = params.network}),
      shape_({.least_radius_px = params.least_radius_px, .least_confidence = kLeastShape}) {
  if (!network_.description().witnesses) {
    throw ConfigError(ConfigProblem{
        .where = {FindNetwork(params.network).string(), 0},
        .key = "witnesses_offset",
        .text = "is missing: the network was not calibrated together with color_shape"});
  }
}

std::vector<WitnessedProposal> CombinedDetector::Propose(const ImageView& image) {
  std::vector<Box> shapes = shape_.Detect(image);
  std::vector<WitnessedProposal> proposals;
  for (NetworkProposal& network : network_.Propose(image)) {
    WitnessedProposal proposal{.network = std::move(network), .shape = {}};
    const auto same = std::ranges::find_if(shapes, [&proposal](const Box& shape) {
      return Overlap(RectOf(shape), RectOf(proposal.network.box)) >= kSameObject;
    });
    if (same != shapes.end()) {
      proposal.shape = std::move(*same);
      shapes.erase(same);
    }
    proposals.push_back(std::move(proposal));
  }
  for (const Box& shape : shapes) {
    proposals.push_back(
        {.network = network_.Weigh(image, shape), .shape = shape, .is_of_network = false});
  }
  return proposals;
}

std::vector<Box> CombinedDetector::Detect(const ImageView& image) {
  std::vector<Box> boxes;
  for (const WitnessedProposal& proposal : Propose(image)) {
    Box box = proposal.network.box;
    box.confidence = ConfidenceOf(*network_.description().witnesses, proposal);
    if (box.confidence >= params_.least_confidence) boxes.push_back(std::move(box));
  }
  std::ranges::stable_sort(boxes, std::ranges::greater(), &Box::confidence);
  return boxes;
}

LIMPET_REGISTER_DETECTOR(CombinedDetector, "combined");

}  // namespace limpet
