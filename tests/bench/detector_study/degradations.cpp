// SPDX-License-Identifier: MIT
#include "tests/bench/detector_study/degradations.hpp"

#include <cstdint>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

cv::Mat Scaled(const cv::Mat& picture, double factor) {
  cv::Mat made;
  picture.convertTo(made, -1, factor);
  return made;
}

/// 70 % of every pixel is the picture's mean colour.
cv::Mat Hazy(const cv::Mat& picture) {
  cv::Mat made;
  cv::addWeighted(picture, 0.3, cv::Mat(picture.size(), picture.type(), cv::mean(picture)), 0.7,
                  0.0, made);
  return made;
}

cv::Mat Compressed(const cv::Mat& picture) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 20});
  return cv::imdecode(bytes, cv::IMREAD_COLOR);
}

cv::Mat Blurred(const cv::Mat& picture) {
  cv::Mat made;
  cv::GaussianBlur(picture, made, {}, 2.0);
  return made;
}

cv::Mat Noisy(const cv::Mat& picture) {
  cv::Mat levels;
  picture.convertTo(levels, CV_32F);
  cv::Mat noise(levels.size(), levels.type());
  cv::RNG(11).fill(noise, cv::RNG::NORMAL, 0.0, 10.0);
  levels += noise;
  cv::Mat made;
  levels.convertTo(made, CV_8U);
  return made;
}

cv::Mat WithoutRed(const cv::Mat& picture) {
  cv::Mat made;
  cv::multiply(picture, cv::Scalar(1.0, 1.0, 0.35), made);
  return made;
}

}  // namespace

const std::vector<Degradation>& Degradations() {
  static const std::vector<Degradation> all{
      {"as taken", [](const cv::Mat& picture) { return picture.clone(); }},
      {"exposure x 0.5", [](const cv::Mat& picture) { return Scaled(picture, 0.5); }},
      {"exposure x 1.8", [](const cv::Mat& picture) { return Scaled(picture, 1.8); }},
      {"haze 70 %", Hazy},
      {"JPEG q20", Compressed},
      {"blur, sigma 2 px", Blurred},
      {"noise, sigma 10", Noisy},
      {"red x 0.35", WithoutRed}};
  return all;
}

}  // namespace limpet
