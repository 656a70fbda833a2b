// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>

#include "training/detector/labelled_picture.hpp"

namespace limpet {

/// Pictures of one size with their labels, as train.py reads them: `pixels.bin`, bytes, blue,
/// green, red, row by row, picture by picture; `labels.csv`, in units of its pixels.
class FrameFile {
 public:
  static constexpr int kShrink = 2;
  static constexpr int kWidth = LabelledPicture::kWidth / kShrink;
  static constexpr int kHeight = LabelledPicture::kHeight / kShrink;

  /// Throws std::runtime_error if `folder` cannot be written.
  explicit FrameFile(const std::filesystem::path& folder);
  void Add(const LabelledPicture& picture);
  [[nodiscard]] int frames() const { return frames_; }

 private:
  std::ofstream pixels_;
  std::ofstream labels_;
  int frames_ = 0;
};

}  // namespace limpet
