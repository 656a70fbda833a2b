// SPDX-License-Identifier: MIT
// Frames of real water (not in the repository).
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>

#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_file.hpp"
#include "limpet/vision/sphere_box.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
const fs::path kData = fs::path(LIMPET_SOURCE_DIR) / ".." / "shared" / "data";

struct Label {
  std::string color;
  PixelRect rect;
  double visible_fraction = 0.0;
};

std::map<std::string, std::vector<Label>> ReadLabels(const fs::path& file) {
  std::ifstream in(file);
  std::map<std::string, std::vector<Label>> labels;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::stringstream text(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(text, field, ',');) {
      fields.push_back(field);
    }
    const double x = std::stod(fields.at(5));
    const double y = std::stod(fields.at(6));
    labels[fields.at(0)].push_back(
        {fields.at(1),
         {x, y, x + std::stod(fields.at(7)), y + std::stod(fields.at(8))},
         std::stod(fields.at(10))});
  }
  return labels;
}

struct Score {
  int right = 0, wrong = 0, missed = 0;
};

Score ScoreOf(std::vector<Box> boxes, const std::vector<Label>& labels, const std::string& color) {
  std::erase_if(boxes, [&color](const Box& box) { return box.color != color; });
  Score score;
  for (const Label& label : labels) {
    if (label.color != color) {
      continue;
    }
    const auto match = std::ranges::find_if(boxes, [&label](const Box& box) {
      const PixelRect rect{box.u - 0.5 * box.w, box.v - 0.5 * box.h, box.u + 0.5 * box.w,
                           box.v + 0.5 * box.h};
      return Overlap(rect, label.rect) >= 0.5;
    });
    const bool counts = label.visible_fraction >= 0.5;
    if (match != boxes.end()) {
      boxes.erase(match);
      score.right += counts ? 1 : 0;
    } else {
      score.missed += counts ? 1 : 0;
    }
  }
  score.wrong = static_cast<int>(boxes.size());
  return score;
}

class RealBuoys : public testing::TestWithParam<const char*> {};

TEST_P(RealBuoys, AreFoundWithFewMistakes) {
  const fs::path folder = kData / "buoys";
  if (!fs::exists(folder / "labels.csv")) {
    GTEST_SKIP() << "no real frames in " << folder;
  }
  Score all;
  const std::unique_ptr<Detector> detector = MakeDetector("color_shape");
  for (const auto& [name, labels] : ReadLabels(folder / "labels.csv")) {
    const auto image = ReadImage(folder / name);
    ASSERT_TRUE(image) << image.error().text;
    const Score one = ScoreOf(detector->Detect(image->view()), labels, GetParam());
    all.right += one.right, all.wrong += one.wrong, all.missed += one.missed;
  }
  EXPECT_GE(all.right, 0.95 * (all.right + all.missed));
  EXPECT_GE(all.right, 0.95 * (all.right + all.wrong));
}
INSTANTIATE_TEST_SUITE_P(Colors, RealBuoys, testing::Values("yellow", "orange", "green"));

TEST(RealGates, CauseFewYellowOrOrangeBoxes) {
  const fs::path folder = kData / "gate_itu" / "images";
  if (!fs::exists(folder)) {
    GTEST_SKIP() << "no real frames in " << folder;
  }
  const std::unique_ptr<Detector> detector = MakeDetector("color_shape");
  int images = 0;
  int boxes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const auto image = ReadImage(entry.path());
    ASSERT_TRUE(image) << image.error().text;
    ++images;
    for (const Box& box : detector->Detect(image->view())) {
      boxes += box.color == "yellow" || box.color == "orange" ? 1 : 0;
    }
  }
  EXPECT_LE(boxes, 0.15 * images);
}

}  // namespace
}  // namespace limpet
