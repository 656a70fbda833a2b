// SPDX-License-Identifier: MIT
#include "limpet/detectors/color_planes.hpp"

#include <algorithm>
#include <cstdint>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

/// The map whose length is a colour's distance from the scene's usual ones, in their standard
/// deviations: three columns of a matrix and one to add.
class UsualColors {
 public:
  UsualColors(const cv::Mat& bgr, double noise) {
    // Three rounds: each forgets what the one before found unusual.
    for (const double limit : {1e9, 9.0, 9.0}) {
      double count = 0.0;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
      const auto* pixels = bgr.ptr<std::uint8_t>();
      for (std::size_t i = 0; i < bgr.total(); i += 7) {
        const Eigen::Vector3d color(pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]);
        if ((whiten_ * (color - mean_)).squaredNorm() < limit) {
          count += 1.0;
          sum += color;
          squares += color * color.transpose();
        }
      }
      if (count < 30.0) {
        return;
      }
      mean_ = sum / count;
      const Eigen::Matrix3d covariance =
          squares / count - mean_ * mean_.transpose() + noise * noise * Eigen::Matrix3d::Identity();
      whiten_ = covariance.llt().matrixL().solve(Eigen::Matrix3d::Identity().eval());
    }
  }
  [[nodiscard]] cv::Matx34f Map() const {
    const Eigen::Vector3d shift = -whiten_ * mean_;
    cv::Matx34f map;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        map(row, column) = static_cast<float>(whiten_(row, column));
      }
      map(row, 3) = static_cast<float>(shift(row));
    }
    return map;
  }

 private:
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d whiten_ = Eigen::Matrix3d::Zero();
};

constexpr int kMostValue = 4096;  ///< of what a histogram counts; brighter values are no background

/// Value below which `share` of the counted pixels lie.
double Quantile(const cv::Mat& histogram, double share) {
  const double wanted = share * cv::sum(histogram)[0];
  double below = 0.0;
  int bin = 0;
  for (; bin < histogram.rows - 1; ++bin) {
    below += static_cast<double>(histogram.at<float>(bin));
    if (below > wanted) {
      break;
    }
  }
  return bin - kMostValue;
}

}  // namespace

void ColorPlanes::Fill(const cv::Mat& bgr, double noise) {
  bgr.convertTo(colors_, CV_32F);
  FillOpponents();
  FillUnusual(bgr, noise);
}

void ColorPlanes::FillOpponents() {
  // Of blue, green, red and 1; the last row is what the others are divided by, never 0.
  static const cv::Matx44f kMix(-1.0F, 0.5F, 0.5F, 0.0F,   //
                                0.0F, -1.0F, 1.0F, 0.0F,   //
                                -0.5F, 1.0F, -0.5F, 0.0F,  //
                                1.0F, 1.0F, 1.0F, 48.0F);
  constexpr double kScale = 2048.0;
  cv::transform(colors_, mixed_, kMix);
  cv::split(mixed_, parts_.data());
  for (std::size_t i = 0; i < 3; ++i) {
    cv::divide(parts_[i], parts_[3], parts_[i], kScale);
    parts_[i].convertTo(planes_[i], CV_16S);
  }
}

void ColorPlanes::FillUnusual(const cv::Mat& bgr, double noise) {
  constexpr double kScale = 16.0;  // per standard deviation
  cv::transform(colors_, mixed_, UsualColors(bgr, noise).Map());
  cv::multiply(mixed_, mixed_, mixed_);
  cv::transform(mixed_, squared_, cv::Matx13f(1.0F, 1.0F, 1.0F));
  cv::sqrt(squared_, squared_);
  squared_.convertTo(planes_[3], CV_16S, kScale);
}

const std::vector<int>& ColorPlanes::LevelsOf(const cv::Mat& plane) {
  constexpr double kFirst = 2.0;  // in spreads above the median
  constexpr double kGrowth = 1.25;
  plane.convertTo(squared_, CV_32F);
  constexpr std::array<float, 2> kRange{-kMostValue, kMostValue};
  std::array<const float*, 1> ranges{kRange.data()};
  const std::array<int, 1> channels{0};
  const std::array<int, 1> bins{2 * kMostValue};
  cv::calcHist(&squared_, 1, channels.data(), cv::Mat(), histogram_, 1, bins.data(), ranges.data());
  const double median = Quantile(histogram_, 0.5);
  // The darker half: objects do not widen it.
  const double spread = std::max(median - Quantile(histogram_, 0.16), 4.0);
  double brightest = 0.0;
  cv::minMaxLoc(plane, nullptr, &brightest);
  levels_.clear();
  for (double step = kFirst * spread; median + step < brightest; step *= kGrowth) {
    levels_.push_back(static_cast<int>(median + step));
  }
  return levels_;
}

}  // namespace limpet
