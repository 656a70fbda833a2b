// SPDX-License-Identifier: MIT
// Frames of real water (not in the repository), and what a detector makes of them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_file.hpp"
#include "tests/support/labelled_frames.hpp"

namespace limpet::real_frames {

/// What a detector must reach on balls of a colour.
struct Bound {
  std::string color;
  double recall = 0.0, precision = 0.0;
};

/// Absent on a user's machine.
inline std::filesystem::path Folder(const std::string& name) {
  return std::filesystem::path(LIMPET_SOURCE_DIR) / ".." / "shared" / "data" / name;
}

/// Boxes that pNav would use at its default `min_confidence`.
inline std::vector<Box> UsedBoxes(Detector& detector, const std::filesystem::path& file) {
  const auto image = ReadImage(file);
  EXPECT_TRUE(image);
  if (!image) return {};
  std::vector<Box> boxes = detector.Detect(image->view());
  constexpr double kUsed = 0.45;
  std::erase_if(boxes, [](const Box& box) { return box.confidence < kUsed; });
  return boxes;
}

/// Of the buoys of one colour.
inline DetectionTally TallyBuoys(const std::string& name, const std::string& color) {
  DetectionTally all;
  const std::unique_ptr<Detector> detector = MakeDetector(name);
  const auto is_other = [&color](const auto& one) { return one.color != color; };
  const std::filesystem::path folder = Folder("buoys");
  for (const auto& [file, marked] : ReadFrameLabels(folder / "labels.csv")) {
    std::vector<Box> boxes = UsedBoxes(*detector, folder / file);
    std::vector<FrameLabel> labels = marked;
    std::erase_if(boxes, is_other);
    std::erase_if(labels, is_other);
    all.Add(TallyBoxes(boxes, labels));
  }
  return all;
}

/// Boxes of these colours (of any, if none is named) per picture of a gate.
inline double BoxesPerGate(const std::string& name, const std::vector<std::string>& colors) {
  const std::unique_ptr<Detector> detector = MakeDetector(name);
  int images = 0;
  int boxes = 0;
  for (const std::filesystem::directory_entry& entry :
       std::filesystem::directory_iterator(Folder("gate_itu/images"))) {
    ++images;
    for (const Box& box : UsedBoxes(*detector, entry.path())) {
      const bool counts = colors.empty() || std::ranges::find(colors, box.color) != colors.end();
      boxes += counts ? 1 : 0;
    }
  }
  return static_cast<double>(boxes) / std::max(1, images);
}

}  // namespace limpet::real_frames
