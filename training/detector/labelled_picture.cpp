// SPDX-License-Identifier: MIT
#include "training/detector/labelled_picture.hpp"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

// What the network is not asked for.
constexpr double kLeastSide = 14.0;      // [px]
constexpr double kMostShare = 0.5;       // of the picture
constexpr double kLeastContrast = 10.0;  // [levels]

bool IsUnclear(const BallLabel& label) {
  constexpr double kPicture = double{LabelledPicture::kWidth} * LabelledPicture::kHeight;
  const Box& box = label.box;
  return label.is_hidden || std::min(box.w, box.h) < kLeastSide ||
         box.w * box.h > kMostShare * kPicture || label.contrast < kLeastContrast;
}

/// How far the mean colour within the box's ellipse is from that of a ring around it [levels].
double ContrastOf(const cv::Mat3b& picture, const Box& box) {
  cv::Vec3d inside(0.0, 0.0, 0.0);
  cv::Vec3d outside(0.0, 0.0, 0.0);
  int inside_count = 0;
  int outside_count = 0;
  for (int row = std::max(0, static_cast<int>(box.v - box.h));
       row < std::min(picture.rows, static_cast<int>(box.v + box.h)); ++row) {
    for (int column = std::max(0, static_cast<int>(box.u - box.w));
         column < std::min(picture.cols, static_cast<int>(box.u + box.w)); ++column) {
      const double across = (column + 0.5 - box.u) / (0.5 * box.w);
      const double along = (row + 0.5 - box.v) / (0.5 * box.h);
      const double scale2 = across * across + along * along;
      if (scale2 < 0.8) {
        inside += picture(row, column);
        ++inside_count;
      } else if (scale2 > 1.3 && scale2 < 2.6) {
        outside += picture(row, column);
        ++outside_count;
      }
    }
  }
  if (inside_count == 0 || outside_count == 0) return 0.0;
  return cv::norm(inside / inside_count - outside / outside_count);
}

}  // namespace

void MarkUnclear(LabelledPicture& picture) {
  // At half the size, as the network sees it: what noise leaves of a contrast.
  cv::Mat3b small;
  cv::resize(picture.pixels, small, {}, 0.5, 0.5, cv::INTER_AREA);
  for (BallLabel& label : picture.labels) {
    Box reduced = label.box;
    for (double* value : {&reduced.u, &reduced.v, &reduced.w, &reduced.h})
      *value *= 0.5;
    label.contrast = ContrastOf(small, reduced);
    label.is_unclear = IsUnclear(label);
  }
}

}  // namespace limpet
