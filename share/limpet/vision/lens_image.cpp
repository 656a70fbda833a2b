// SPDX-License-Identifier: MIT
#include "limpet/vision/lens_image.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/vision/image_mat.hpp"

namespace limpet {

/// Where in the pinhole's image each pixel of the lens's image comes from.
struct LensImage::Map {
  cv::Mat places, weights;
};

LensImage::LensImage(const LensModel& lens) : map_(std::make_unique<Map>()) {
  const CameraModel& image = lens.image();
  cv::Mat places(image.height_px, image.width_px, CV_32FC2);
  for (int row = 0; row < image.height_px; ++row) {
    for (int column = 0; column < image.width_px; ++column) {
      const Eigen::Vector2d p = lens.ToPinhole(lens.enclosing(), {column + 0.5, row + 0.5});
      // OpenCV counts from the middle of the first pixel.
      places.at<cv::Vec2f>(row, column) = {static_cast<float>(p.x() - 0.5),
                                           static_cast<float>(p.y() - 0.5)};
    }
  }
  cv::convertMaps(places, cv::noArray(), map_->places, map_->weights, CV_16SC2);
}

LensImage::~LensImage() = default;
LensImage::LensImage(LensImage&&) noexcept = default;
LensImage& LensImage::operator=(LensImage&&) noexcept = default;

Image LensImage::Distorted(const Image& pinhole) const {
  const cv::Mat from = MatOf(pinhole.view());
  Image image{map_->places.cols, map_->places.rows, {}};
  image.bgr.resize(3 * map_->places.total());
  cv::Mat to(image.height_px, image.width_px, CV_8UC3, image.bgr.data());
  cv::remap(from, to, map_->places, map_->weights, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return image;
}

}  // namespace limpet
