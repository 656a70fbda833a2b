// SPDX-License-Identifier: MIT
#include "limpet/planning/ground.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"

namespace limpet {

Footprint::Footprint(double altitude, double object_height_max, const CameraModel& camera) {
  const double across = camera.half_across();
  const double along = camera.half_along();
  for (int layer = 0; layer < kLayers; ++layer) {
    const std::size_t k = Slot(layer);
    height_[k] = std::max(0.0, object_height_max) * layer / (kLayers - 1);
    const double inset = layer == 0 || object_height_max <= 0.0 ? 0.0 : SurveyGrid::kDiscInset;
    const double distance = std::max(0.0, altitude - height_[k]);
    across_[k] = std::max(0.0, distance * across - inset);
    along_[k] = std::max(0.0, distance * along - inset);
  }
}

double Footprint::swath() const {
  double sum = 0.0;
  for (const double half : across_) {
    sum += 2.0 * half;
  }
  return sum / kLayers;
}

Ground::Ground(const SurveyGrid& grid, const Footprint& footprint, const LayerWeights& weights)
    : frame_(grid.frame()), footprint_(footprint), weights_(weights) {
  levels_.resize(grid.heights().size());
  Update(grid);
}

void Ground::Update(const SurveyGrid& grid) {
  LIMPET_REQUIRE(grid.heights().size() == levels_.size(), "a ground mirrors one grid");
  if (version_ == grid.version()) {
    return;
  }
  version_ = grid.version();
  constexpr float kTolerance = 1e-3F;
  std::array<float, Footprint::kLayers> floors{};
  for (int layer = 0; layer < Footprint::kLayers; ++layer) {
    floors[static_cast<std::size_t>(layer)] =
        std::max(0.0F, static_cast<float>(footprint_.height(layer)) - kTolerance);
  }
  const std::span<const float> heights = grid.heights();
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    int level = 0;
    for (const float floor : floors) {
      level += heights[i] >= floor ? 1 : 0;
    }
    levels_[i] = static_cast<std::uint8_t>(level);
  }
}

double Ground::swath() const {
  double sum = 0.0;
  for (int layer = 0; layer < Footprint::kLayers; ++layer) {
    sum += 2.0 * footprint_.half_across(layer) * weights_[static_cast<std::size_t>(layer)];
  }
  return sum;
}

double Ground::SeenShare() const {
  double sum = 0.0;
  for (const std::uint8_t level : levels_) {
    sum += level;
  }
  return sum / (Footprint::kLayers * static_cast<double>(levels_.size()));
}

double Ground::SeenShare(int layer) const {
  const auto seen = std::count_if(levels_.begin(), levels_.end(),
                                  [layer](std::uint8_t level) { return level > layer; });
  return static_cast<double>(seen) / static_cast<double>(levels_.size());
}

}  // namespace limpet
