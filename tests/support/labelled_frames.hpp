// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "limpet/objects/pixel_rect.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// A ball that somebody marked in a frame.
struct FrameLabel {
  std::string color;
  PixelRect rect;
  double visible_fraction = 1.0;
  double u = 0.0, v = 0.0, radius = 0.0;  ///< of its circle [px]

  /// Those that are mostly hidden may be found or not.
  [[nodiscard]] bool counts() const { return visible_fraction >= 0.5; }
};

/// Labels by file name: `frame,colour,cx,cy,radius,x,y,w,h,truncated,visible_frac`, a header first.
[[nodiscard]] std::map<std::string, std::vector<FrameLabel>> ReadFrameLabels(
    const std::filesystem::path& file);

/// How a detector's boxes agree with labels, an overlap (IoU) of 0.5 being a find.
struct DetectionTally {
  int found = 0;        ///< labels that count, by a box of whatever class
  int right_class = 0;  ///< those of them whose box has their class
  int missed = 0;
  int invented = 0;  ///< boxes that are at no label

  void Add(const DetectionTally& other);
  [[nodiscard]] double recall() const;
  [[nodiscard]] double precision() const;
  /// A box of a wrong class counts as missed and as invented.
  [[nodiscard]] double class_recall() const;
  [[nodiscard]] double class_precision() const;
};

/// `right` gets, for each box, whether it is at a label and of its class; 2 for one at a label that
/// does not count. May be null.
[[nodiscard]] DetectionTally TallyBoxes(const std::vector<Box>& boxes,
                                        const std::vector<FrameLabel>& labels,
                                        std::vector<int>* right = nullptr);

}  // namespace limpet
