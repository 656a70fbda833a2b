// SPDX-License-Identifier: MIT
#include "tests/bench/image_formation/picture_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

float Percentile(cv::Mat values, double share) {
  std::vector<float> sorted(values.begin<float>(), values.end<float>());
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
  return sorted[static_cast<std::size_t>(at)];
}

double MeanSpreadWithin(const cv::Mat& gray, int side) {
  double sum = 0.0;
  int windows = 0;
  for (int row = 0; row + side <= gray.rows; row += side) {
    for (int column = 0; column + side <= gray.cols; column += side) {
      cv::Scalar mean;
      cv::Scalar deviation;
      cv::meanStdDev(gray(cv::Rect(column, row, side, side)), mean, deviation);
      sum += deviation[0];
      ++windows;
    }
  }
  return sum / windows;
}

cv::Mat AtWidth640(const ImageView& picture) {
  const cv::Mat given(picture.height_px, picture.width_px, CV_8UC3,
                      const_cast<std::uint8_t*>(picture.bgr));  // OpenCV's Mat is not const
  if (picture.width_px == 640) return given;
  cv::Mat scaled;
  const int height = static_cast<int>(std::lround(640.0 * picture.height_px / picture.width_px));
  cv::resize(given, scaled, {640, height}, 0.0, 0.0,
             picture.width_px > 640 ? cv::INTER_AREA : cv::INTER_LINEAR);
  return scaled;
}

}  // namespace

PictureStatistics StatisticsOf(const ImageView& picture) {
  const cv::Mat bgr = AtWidth640(picture);
  cv::Mat gray8;
  cv::cvtColor(bgr, gray8, cv::COLOR_BGR2GRAY);
  cv::Mat gray;
  gray8.convertTo(gray, CV_32F);
  PictureStatistics result;
  result.dark = Percentile(gray, 0.01);
  result.bright = Percentile(gray, 0.99);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(gray, mean, deviation);
  result.spread = deviation[0];
  result.local_spread = MeanSpreadWithin(gray, 16);
  result.fine_spread = MeanSpreadWithin(gray, 8);

  cv::Mat across;
  cv::Mat along;
  cv::Mat magnitude;
  cv::Sobel(gray, across, CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(gray, along, CV_32F, 0, 1, 3, 0.125);
  cv::magnitude(across, along, magnitude);
  result.gradient_50 = Percentile(magnitude, 0.5);
  result.gradient_95 = Percentile(magnitude, 0.95);
  cv::Mat edges;
  cv::Canny(gray8, edges, 50.0, 150.0);
  result.edges = cv::countNonZero(edges) / static_cast<double>(edges.total());

  cv::Mat lab;
  cv::Mat scaled;
  bgr.convertTo(scaled, CV_32F, 1.0 / 255.0);
  cv::cvtColor(scaled, lab, cv::COLOR_BGR2Lab);
  cv::meanStdDev(lab, mean, deviation);
  result.chroma_spread = std::hypot(deviation[1], deviation[2]);
  std::vector<cv::Mat> planes;
  cv::split(lab, planes);
  cv::magnitude(planes[1], planes[2], magnitude);
  result.chroma = cv::mean(magnitude)[0];
  return result;
}

}  // namespace limpet
