// SPDX-License-Identifier: MIT
#include "tests/support/labelled_frames.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace limpet {
namespace {

double Share(int part, int rest) {
  return part + rest > 0 ? static_cast<double>(part) / (part + rest) : 1.0;
}

}  // namespace

std::map<std::string, std::vector<FrameLabel>> ReadFrameLabels(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::map<std::string, std::vector<FrameLabel>> labels;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::stringstream text(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(text, field, ',');)
      fields.push_back(field);
    const auto number = [&fields](std::size_t i) { return std::stod(fields.at(i)); };
    labels[fields.at(0)].push_back(
        {.color = fields.at(1),
         .rect = {number(5), number(6), number(5) + number(7), number(6) + number(8)},
         .visible_fraction = number(10),
         .u = number(2),
         .v = number(3),
         .radius = number(4)});
  }
  return labels;
}

void DetectionTally::Add(const DetectionTally& other) {
  found += other.found;
  right_class += other.right_class;
  missed += other.missed;
  invented += other.invented;
}
double DetectionTally::recall() const { return Share(found, missed); }
double DetectionTally::precision() const { return Share(found, invented); }
double DetectionTally::class_recall() const {
  return Share(right_class, found - right_class + missed);
}
double DetectionTally::class_precision() const {
  return Share(right_class, found - right_class + invented);
}

DetectionTally TallyBoxes(const std::vector<Box>& boxes, const std::vector<FrameLabel>& labels,
                          std::vector<int>* right) {
  DetectionTally tally;
  std::vector<bool> taken(labels.size(), false);
  if (right != nullptr) right->assign(boxes.size(), 0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::size_t best = labels.size();
    double best_overlap = 0.5;
    for (std::size_t k = 0; k < labels.size(); ++k) {
      const double overlap = Overlap(RectOf(boxes[i]), labels[k].rect);
      if (!taken[k] && overlap >= best_overlap) best = k, best_overlap = overlap;
    }
    if (best == labels.size()) {
      ++tally.invented;
      continue;
    }
    taken[best] = true;
    const bool has_class = boxes[i].color == labels[best].color;
    if (labels[best].counts()) {
      ++tally.found;
      tally.right_class += has_class ? 1 : 0;
    }
    if (right != nullptr) (*right)[i] = labels[best].counts() ? (has_class ? 1 : 0) : 2;
  }
  for (std::size_t k = 0; k < labels.size(); ++k)
    tally.missed += !taken[k] && labels[k].counts() ? 1 : 0;
  return tally;
}

}  // namespace limpet
