// SPDX-License-Identifier: MIT
// Frames of real water (not in the repository).
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_file.hpp"
#include "tests/support/labelled_frames.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
const fs::path kData = fs::path(LIMPET_SOURCE_DIR) / ".." / "shared" / "data";
constexpr double kUsed = 0.45;  ///< pNav's min_confidence

std::vector<Box> UsedBoxes(Detector& detector, const fs::path& file) {
  const auto image = ReadImage(file);
  EXPECT_TRUE(image);
  if (!image) return {};
  std::vector<Box> boxes = detector.Detect(image->view());
  std::erase_if(boxes, [](const Box& box) { return box.confidence < kUsed; });
  return boxes;
}

struct Bound {
  std::string detector;
  std::string color;
  double recall = 0.0, precision = 0.0;
};

class RealBuoys : public testing::TestWithParam<Bound> {};

TEST_P(RealBuoys, AreFoundWithFewMistakes) {
  const Bound& bound = GetParam();
  const fs::path folder = kData / "buoys";
  if (!fs::exists(folder / "labels.csv")) GTEST_SKIP() << "no real frames in " << folder;
  DetectionTally all;
  const std::unique_ptr<Detector> detector = MakeDetector(bound.detector);
  const auto is_other = [&bound](const auto& one) { return one.color != bound.color; };
  for (const auto& [file, marked] : ReadFrameLabels(folder / "labels.csv")) {
    std::vector<Box> boxes = UsedBoxes(*detector, folder / file);
    std::vector<FrameLabel> labels = marked;
    std::erase_if(boxes, is_other);
    std::erase_if(labels, is_other);
    all.Add(TallyBoxes(boxes, labels));
  }
  EXPECT_GE(all.recall(), bound.recall);
  EXPECT_GE(all.precision(), bound.precision);
}
// The network is shy of green balls in green water (docs/detectors.md).
INSTANTIATE_TEST_SUITE_P(
    Colors, RealBuoys,
    testing::Values(Bound{"color_shape", "yellow", 0.97, 0.97},
                    Bound{"color_shape", "orange", 0.97, 0.97},
                    Bound{"color_shape", "green", 0.9, 0.9}, Bound{"network", "yellow", 0.97, 0.97},
                    Bound{"network", "orange", 0.97, 0.97}, Bound{"network", "green", 0.4, 0.97}),
    [](const auto& bound) { return bound.param.detector + "_" + bound.param.color; });

/// Boxes of these colours (of any, if none is named) per picture of a gate.
double BoxesPerGate(const std::string& name, const std::vector<std::string>& colors) {
  const std::unique_ptr<Detector> detector = MakeDetector(name);
  int images = 0;
  int boxes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kData / "gate_itu" / "images")) {
    ++images;
    for (const Box& box : UsedBoxes(*detector, entry.path())) {
      const bool counts = colors.empty() || std::ranges::find(colors, box.color) != colors.end();
      boxes += counts ? 1 : 0;
    }
  }
  return static_cast<double>(boxes) / std::max(1, images);
}

TEST(RealGates, CauseFewYellowOrOrangeBoxes) {
  if (!fs::exists(kData / "gate_itu" / "images")) GTEST_SKIP() << "no real frames in " << kData;
  EXPECT_LE(BoxesPerGate("color_shape", {"yellow", "orange"}), 0.15);
}

TEST(RealGates, CauseHardlyAnyBoxOfTheNetwork) {
  if (!fs::exists(kData / "gate_itu" / "images")) GTEST_SKIP() << "no real frames in " << kData;
  EXPECT_LE(BoxesPerGate("network", {}), 0.1);
}

}  // namespace
}  // namespace limpet
