// SPDX-License-Identifier: MIT
#include "limpet/planning/ground.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"
#include "limpet/survey/sight_reach.hpp"

namespace limpet {
namespace {

constexpr double kLeastSwath = 1e-3;  // [m]

}  // namespace

Footprint::Footprint(double altitude, double object_height_max, const CameraModel& camera,
                     double reach) {
  const double across = camera.half_across();
  const double along = camera.half_along();
  double scale = 1.0;
  for (int layer = 0; layer < kLayers; ++layer) {
    const std::size_t k = Slot(layer);
    height_[k] = std::max(0.0, object_height_max) * layer / (kLayers - 1);
    const double inset = layer == 0 || object_height_max <= 0.0 ? 0.0 : SurveyGrid::kDiscInset;
    const double distance = std::max(0.0, altitude - height_[k]);
    across_[k] = std::max(0.0, distance * across - inset);
    along_[k] = std::max(0.0, distance * along - inset);
    const double share = ShareInSight(distance, std::hypot(across_[k], along_[k]), reach);
    in_reach_[k] = share > 0.0;
    scale = in_reach_[k] ? std::min(scale, share) : scale;
    across_[k] *= in_reach_[k] ? scale : 0.0;
    along_[k] *= in_reach_[k] ? scale : 0.0;
  }
}

void Footprint::DrawIn(double by) {
  for (std::size_t k = 0; k < kLayers; ++k) {
    across_[k] = std::max(0.0, across_[k] - by);
    along_[k] = std::max(0.0, along_[k] - by);
  }
}

double Footprint::swath() const {
  double sum = 0.0;
  for (const double half : across_) {
    sum += 2.0 * half;
  }
  return std::max(kLeastSwath, sum / kLayers);
}

int Footprint::widest_layer() const {
  const auto found = std::find(in_reach_.begin(), in_reach_.end(), true);
  return found == in_reach_.end() ? 0 : static_cast<int>(found - in_reach_.begin());
}

Ground::Ground(const SurveyGrid& grid, const Footprint& footprint, const LayerWeights& weights)
    : frame_(grid.frame()),
      footprint_(footprint),
      weights_(weights),
      wanted_cells_(std::max<std::size_t>(1, grid.wanted_cells())) {
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
  const std::span<const float> seen = grid.heights();
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const float floor = grid.Floor(i);
    int level = grid.IsWanted(i) ? 0 : Footprint::kLayers;
    while (level < Footprint::kLayers) {
      const auto height = static_cast<float>(footprint_.height(level));
      const bool is_seen =
          seen[i] >= std::max(0.0F, height - kTolerance) && floor <= height + kTolerance;
      if (!is_seen && footprint_.is_in_reach(level)) break;
      ++level;
    }
    levels_[i] = static_cast<std::uint8_t>(level);
  }
}

double Ground::swath() const {
  double sum = 0.0;
  for (int layer = 0; layer < Footprint::kLayers; ++layer) {
    sum += 2.0 * footprint_.half_across(layer) * weights_[static_cast<std::size_t>(layer)];
  }
  return std::max(kLeastSwath, sum);
}

double Ground::SeenShare() const {
  double sum = 0.0;
  for (const std::uint8_t level : levels_) {
    sum += level;
  }
  const auto unwanted = static_cast<double>(levels_.size() - wanted_cells_);
  return (sum - Footprint::kLayers * unwanted) /
         (Footprint::kLayers * static_cast<double>(wanted_cells_));
}

double Ground::SeenShare(int layer) const {
  const auto seen = std::count_if(levels_.begin(), levels_.end(),
                                  [layer](std::uint8_t level) { return level > layer; });
  const auto unwanted = static_cast<double>(levels_.size() - wanted_cells_);
  return (static_cast<double>(seen) - unwanted) / static_cast<double>(wanted_cells_);
}

}  // namespace limpet
