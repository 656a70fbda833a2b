// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace limpet {

/// One connected region of a level set, holes filled, by the moments of its outline. Pixel units of
/// the plane it was found in.
struct Blob {
  double area = 0.0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  cv::Rect bounds;

  /// Area over that of the ellipse with the same second moments: 1 for any full ellipse, less for
  /// branches and crescents.
  double fullness = 0.0;
  /// Long over short axis.
  [[nodiscard]] double Elongation() const;
};

/// Connected regions of level sets. Keeps its buffers from one search to the next.
class BlobFinder {
 public:
  /// Appends the connected regions (8 neighbours) of `plane >= level` with at least `least_area`
  /// pixels, in a fixed order. The plane holds 16-bit signed values.
  void Find(const cv::Mat& plane, int level, double least_area, std::vector<Blob>& blobs);

 private:
  cv::Mat mask_;
  std::vector<std::vector<cv::Point>> outlines_;
};

}  // namespace limpet
