// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limpet {

/// How far a box is to be believed of which a second detector was asked, too: logistic in a
/// constant and in what each of the two witnesses says. Fitted like the network's own confidence.
struct WitnessWeights {
  double offset = 0.0;
  double per_score = 0.0;      ///< logit of the network's score
  double per_color = 0.0;      ///< logit of the network's colour
  double per_roundness = 0.0;  ///< 0 to 1
  double shape_found = 0.0;    ///< `color_shape` has a box there, too
  double per_shape = 0.0;      ///< logit of that box's confidence
};

/// What a detector network's .yaml file says beside its weights: what its cells mean, and how far
/// its scores are to be believed. docs/detectors.md has the format.
struct NetworkDescription {
  std::filesystem::path weights;    ///< ONNX
  std::vector<std::string> colors;  ///< of its class channels, in their order
  int stride_px = 8;                ///< of a cell in the network's input
  double size_unit_px = 32.0;       ///< box size where its channel is 0
  double input_pixels = 76800.0;    ///< images are brought to about as many
  /// Probability that a box is right: logistic in a constant, its score's logit, that of its colour
  /// among all, and how round its outline is. Fitted on pictures that the network has not learned
  /// from.
  double confidence_offset = 0.0;
  double confidence_per_score = 1.0;
  double confidence_per_color = 0.0;
  double confidence_per_roundness = 0.0;
  std::optional<WitnessWeights> witnesses;  ///< where the network was calibrated with another

  /// Throws ConfigError that names file, line and key.
  [[nodiscard]] static NetworkDescription Read(const std::filesystem::path& file);
};

/// `named` as it stands if there is such a file, else in `share/networks` of the folders above the
/// running program. Throws ConfigError that says where it was looked for.
[[nodiscard]] std::filesystem::path FindNetwork(const std::string& named);

}  // namespace limpet
