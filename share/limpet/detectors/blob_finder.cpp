// SPDX-License-Identifier: MIT
#include "limpet/detectors/blob_finder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

/// An outline joins the centres of a region's outermost pixels: it is half a pixel inside the
/// region's edge all the way round.
constexpr double kInset = 0.5;

/// Second moments of the ellipse whose semi-axes are longer by the inset.
Eigen::Matrix2d Grown(const Eigen::Matrix2d& covariance) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(covariance);
  // A filled ellipse has a quarter of its squared semi-axes as variance.
  const Eigen::Array2d halved = axes.eigenvalues().array().max(0.0).sqrt() + 0.5 * kInset;
  const Eigen::Vector2d grown = halved.square();
  return axes.eigenvectors() * grown.asDiagonal() * axes.eigenvectors().transpose();
}

Blob ToBlob(const cv::Moments& moments, const cv::Rect& rect) {
  Blob blob;
  blob.center = {moments.m10 / moments.m00 + kInset, moments.m01 / moments.m00 + kInset};
  Eigen::Matrix2d inner;
  inner << moments.mu20, moments.mu11, moments.mu11, moments.mu02;
  inner /= moments.m00;
  const auto ellipse_area = [](const Eigen::Matrix2d& covariance) {
    return 4.0 * std::numbers::pi * std::sqrt(std::max(covariance.determinant(), 1e-9));
  };
  blob.fullness = moments.m00 / ellipse_area(inner);
  blob.covariance = Grown(inner);
  blob.area = blob.fullness * ellipse_area(blob.covariance);
  blob.bounds = rect;
  return blob;
}

}  // namespace

double Blob::Elongation() const {
  const double half_trace = 0.5 * covariance.trace();
  const double root = std::sqrt(std::max(half_trace * half_trace - covariance.determinant(), 0.0));
  return std::sqrt((half_trace + root) / std::max(half_trace - root, 1e-9));
}

void BlobFinder::Find(const cv::Mat& plane, int level, double least_area,
                      std::vector<Blob>& blobs) {
  cv::compare(plane, level, mask_, cv::CMP_GE);
  cv::findContours(mask_, outlines_, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  for (const std::vector<cv::Point>& outline : outlines_) {
    // Most outlines are those of specks.
    const cv::Rect rect = cv::boundingRect(outline);
    if (rect.area() < least_area) {
      continue;
    }
    const cv::Moments moments = cv::moments(outline);
    if (moments.m00 <= 0.0) {
      continue;
    }
    const Blob blob = ToBlob(moments, rect);
    if (blob.area >= least_area) {
      blobs.push_back(blob);
    }
  }
}

}  // namespace limpet
