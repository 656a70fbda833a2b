// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "limpet/topics/sensors.hpp"

namespace limpet {

/// A ball in a picture, as the network is to report it or to be forgiven for.
struct BallLabel {
  Box box;                  ///< of what is visible; [px] of the picture that it belongs to
  double contrast = 0.0;    ///< mean colour inside less that of a ring around [levels]
  bool is_hidden = false;   ///< less than about half of it is in sight
  bool is_unclear = false;  ///< hidden, too small or too faint to ask for
};

/// A camera's picture with what is in it.
struct LabelledPicture {
  static constexpr int kWidth = 640;
  static constexpr int kHeight = 480;

  cv::Mat3b pixels;
  std::vector<BallLabel> labels;
};

/// Measures the labels' contrast, and marks those as unclear that are too small, too large or too
/// faint to ask for.
void MarkUnclear(LabelledPicture& picture);

}  // namespace limpet
