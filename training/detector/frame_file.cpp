// SPDX-License-Identifier: MIT
#include "training/detector/frame_file.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace limpet {

FrameFile::FrameFile(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  pixels_.open(folder / "pixels.bin", std::ios::binary);
  labels_.open(folder / "labels.csv");
  if (!pixels_ || !labels_) throw std::runtime_error(folder.string() + ": cannot be written");
  labels_ << "frame,class,u,v,w,h,unclear\n";
}

void FrameFile::Add(const LabelledPicture& picture) {
  cv::Mat3b small;
  cv::resize(picture.pixels, small, {kWidth, kHeight}, 0.0, 0.0, cv::INTER_AREA);
  for (const BallLabel& label : picture.labels) {
    const Box& box = label.box;
    labels_ << fmt::format("{},{},{:.2f},{:.2f},{:.2f},{:.2f},{:d}\n", frames_, box.color,
                           box.u / kShrink, box.v / kShrink, box.w / kShrink, box.h / kShrink,
                           label.is_unclear);
  }
  for (int row = 0; row < kHeight; ++row) {
    pixels_.write(reinterpret_cast<const char*>(small.ptr(row)), std::streamsize{3} * kWidth);
  }
  ++frames_;
  if (!pixels_ || !labels_) throw std::runtime_error("writing pictures failed: is the disk full?");
}

}  // namespace limpet
