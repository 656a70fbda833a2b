// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <opencv2/core.hpp>

#include "limpet/detectors/network_description.hpp"
#include "limpet/objects/pixel_rect.hpp"

namespace limpet {

/// What a network says about one object; pixels of its input.
struct NetworkFinding {
  PixelRect rect;
  double score_logit = 0.0;  ///< that an object with about this box is there
  double color_logit = 0.0;  ///< that it has its colour, against all others
  std::size_t color = 0;     ///< index in the description
};

/// Which of a network's findings are kept.
struct FindingLimits {
  double least_logit = 0.0;   ///< of their score
  double most_overlap = 1.0;  ///< of those that overlap by more, as a share, only the best is kept
};

/// Reads the findings of a network's output (1 x channels x rows x columns, 32-bit floats) that the
/// limits allow. Best first.
[[nodiscard]] std::vector<NetworkFinding> ReadCells(const cv::Mat& cells,
                                                    const NetworkDescription& network,
                                                    const FindingLimits& limits);

/// What the network says of a place where somebody else sees an object: of the cells in the inner
/// half of the box that `place` has, the one with the greatest score. Its own box is not asked.
[[nodiscard]] NetworkFinding StrongestAt(const cv::Mat& cells, const NetworkDescription& network,
                                         const PixelRect& place);

}  // namespace limpet
