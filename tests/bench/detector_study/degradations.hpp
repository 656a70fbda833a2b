// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace limpet {

/// A way in which pictures get worse.
struct Degradation {
  std::string name;
  cv::Mat (*apply)(const cv::Mat& picture);
};

/// As taken; half and nearly twice exposed, behind haze, badly compressed, blurred, noisy, in water
/// that took the red.
[[nodiscard]] const std::vector<Degradation>& Degradations();

}  // namespace limpet
