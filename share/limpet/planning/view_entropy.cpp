// SPDX-License-Identifier: MIT
#include "limpet/planning/view_entropy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "limpet/core/entropy.hpp"

namespace limpet {
namespace {

/// OctoMap's clamp leaves a seen voxel at P = 0.971, which keeps 0.13 nat.
constexpr double kSeenNats = 0.13;
/// Voxels of an object that a view from above shows (0.5 m radius, 0.2 m voxels).
constexpr double kVoxelsPerObject = 40.0;

double Entropy(double p) { return MinusPLogP(p) + MinusPLogP(1.0 - p); }

/// Whether the image from `at` shows a place at the height of `layer`.
bool Shows(const Footprint& footprint, const Pose2& at, const std::array<double, 2>& place,
           int layer) {
  const double dn = place[0] - at.north, de = place[1] - at.east;
  const double c = std::cos(at.yaw), s = std::sin(at.yaw);
  return std::abs(dn * c + de * s) <= footprint.half_along(layer) &&
         std::abs(-dn * s + de * c) <= footprint.half_across(layer);
}

/// Entropy of one cell in the image from `at`.
double CellEntropy(const Pose2& at, const Ground& ground, int row, int column, int layers) {
  const GridFrame& frame = ground.frame();
  const std::array<double, 2> place{frame.north_min + (row + 0.5) * frame.cell_m,
                                    frame.east_min + (column + 0.5) * frame.cell_m};
  const int level =
      ground.levels()[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                      static_cast<std::size_t>(column)];
  double nats = 0.0;
  for (int layer = 0; layer < layers; ++layer) {
    if (ground.footprint().is_in_reach(layer) && Shows(ground.footprint(), at, place, layer)) {
      nats += (layer < level ? kSeenNats : std::numbers::ln2) / layers;
    }
  }
  return nats;
}

double ImageEntropy(const Pose2& at, const Ground& ground, bool counts_band) {
  const GridFrame& frame = ground.frame();
  const int layers = counts_band ? Footprint::kLayers : 1;
  const int widest = ground.footprint().widest_layer();
  const double reach =
      std::hypot(ground.footprint().half_along(widest), ground.footprint().half_across(widest));
  const auto cell = [&frame](double offset, int count) {
    return static_cast<int>(std::clamp(offset / frame.cell_m, 0.0, count - 1.0));
  };
  const int row_end = cell(at.north + reach - frame.north_min, frame.rows);
  const int column_end = cell(at.east + reach - frame.east_min, frame.columns);
  double nats = 0.0;
  for (int row = cell(at.north - reach - frame.north_min, frame.rows); row <= row_end; ++row) {
    for (int column = cell(at.east - reach - frame.east_min, frame.columns); column <= column_end;
         ++column) {
      nats += CellEntropy(at, ground, row, column, layers);
    }
  }
  return nats;
}

}  // namespace

std::vector<Pose2> ViewsOf(const Option& option) {
  return option.views.empty() ? std::vector<Pose2>{option.path.end()} : option.views;
}

double MapEntropyOf(std::span<const Pose2> views, const Ground& ground, bool counts_band) {
  double nats = 0.0;
  for (const Pose2& view : views) {
    nats += ImageEntropy(view, ground, counts_band);
  }
  return nats;
}

ObjectEntropy ObjectEntropyOf(std::span<const Pose2> views, const Ground& ground,
                              std::span<const OpiBelief> objects) {
  ObjectEntropy entropy;
  for (const Pose2& view : views) {
    for (const OpiBelief& object : objects) {
      if (!Shows(ground.footprint(), view, {object.object.p_W.x(), object.object.p_W.y()},
                 ground.footprint().widest_layer())) {
        continue;
      }
      if (object.looks > 0) {
        entropy.seen += kVoxelsPerObject * Entropy(object.posterior.present());
      } else if (object.former_id) {
        entropy.inherited += kVoxelsPerObject * MinusPLogP(object.posterior.present());
      }
    }
  }
  return entropy;
}

}  // namespace limpet
