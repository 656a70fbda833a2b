// SPDX-License-Identifier: MIT
#include "limpet/planning/paper_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "limpet/planning/seen_density.hpp"

namespace limpet {
namespace {

constexpr int kDrawsPerNode = 20;
/// OctoMap's clamp leaves a seen voxel at P = 0.971, which keeps 0.13 nat.
constexpr double kSeenNats = 0.13;
/// Voxels of an object that a view from above shows (0.5 m radius, 0.2 m voxels).
constexpr double kVoxelsPerOpi = 40.0;

struct View {
  DubinsPath edge;
  int parent = -1;
  double gain = 0.0;       ///< eq. (17), sum over the branch's views [nats]
  double opi = 0.0;        ///< eqs (18), (19), (21) [nats]
  double inherited = 0.0;  ///< eq. (22) with the sign that attracts [nats]
};

double MinusPLogP(double p) { return p > 0.0 ? -p * std::log(p) : 0.0; }
double Entropy(double p) { return MinusPLogP(p) + MinusPLogP(1.0 - p); }

class PaperTree {
 public:
  PaperTree(const Pose2& start, const Ground& ground, const std::vector<OpiBelief>& opis,
            double covered, const PaperParams& params)
      : ground_(ground), opis_(opis), covered_(covered), params_(params) {
    View root;
    root.edge = DubinsPath(start);
    views_.push_back(std::move(root));
  }

  [[nodiscard]] int Size() const { return static_cast<int>(views_.size()); }
  [[nodiscard]] const View& At(int i) const { return views_[static_cast<std::size_t>(i)]; }

  [[nodiscard]] int Nearest(const Pose2& sample) const {
    int nearest = 0;
    for (int i = 1; i < Size(); ++i) {
      if (Distance(At(i).edge.end(), sample) < Distance(At(nearest).edge.end(), sample)) {
        nearest = i;
      }
    }
    return nearest;
  }

  /// Adds a view at the end of `edge`; false if the motion is none or leaves the region.
  bool Add(int parent, const DubinsPath& edge, const Region& region) {
    if (edge.length() < 1.0 || !region.Contains(edge) ||
        !region.IsRecoverable(edge.end(), params_.turn_radius)) {
      return false;
    }
    View view{.edge = edge,
              .parent = parent,
              .gain = At(parent).gain + GainOf(edge.end()),
              .opi = At(parent).opi,
              .inherited = At(parent).inherited};
    LookAtOpis(edge.end(), view);
    views_.push_back(std::move(view));
    return true;
  }

  /// ln L of eqs (17), (20) or (23).
  [[nodiscard]] double LogGain(int index) const {
    const View& view = At(index);
    const double log_gain = std::log(std::max(view.gain, std::numeric_limits<double>::min()));
    switch (params_.gain) {
      case PaperGain::kCoverage:
        return log_gain;
      case PaperGain::kDiscovery:
        return log_gain + params_.lambda * view.opi;
      case PaperGain::kChange:
        return log_gain + params_.lambda * ((1.0 - covered_) * view.inherited + view.opi);
    }
    return log_gain;
  }

  [[nodiscard]] std::vector<int> BranchTo(int leaf) const {
    std::vector<int> branch;
    for (int i = leaf; i > 0; i = At(i).parent) {
      branch.push_back(i);
    }
    std::reverse(branch.begin(), branch.end());
    return branch;
  }

 private:
  /// Whether the image from `at` shows a place at the height of `layer`.
  [[nodiscard]] bool Shows(const Pose2& at, double north, double east, int layer) const {
    const double dn = north - at.north, de = east - at.east;
    const double c = std::cos(at.yaw), s = std::sin(at.yaw);
    return std::abs(dn * c + de * s) <= ground_.footprint().half_along(layer) &&
           std::abs(-dn * s + de * c) <= ground_.footprint().half_across(layer);
  }

  /// Entropy inside the image of one view; what other views show does not matter (as printed).
  [[nodiscard]] double GainOf(const Pose2& at) const {
    const GridFrame& frame = ground_.frame();
    const int layers = params_.counts_band ? Footprint::kLayers : 1;
    const double reach =
        std::hypot(ground_.footprint().half_along(0), ground_.footprint().half_across(0));
    const auto cell = [&frame](double offset, int count) {
      return static_cast<int>(std::clamp(offset / frame.cell_m, 0.0, count - 1.0));
    };
    double nats = 0.0;
    for (int row = cell(at.north - reach - frame.north_min, frame.rows);
         row <= cell(at.north + reach - frame.north_min, frame.rows); ++row) {
      for (int column = cell(at.east - reach - frame.east_min, frame.columns);
           column <= cell(at.east + reach - frame.east_min, frame.columns); ++column) {
        const double north = frame.north_min + (row + 0.5) * frame.cell_m;
        const double east = frame.east_min + (column + 0.5) * frame.cell_m;
        const int level =
            ground_
                .levels()[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                          static_cast<std::size_t>(column)];
        for (int layer = 0; layer < layers && Shows(at, north, east, layer); ++layer) {
          nats += (layer < level ? kSeenNats : std::numbers::ln2) / layers;
        }
      }
    }
    return nats;
  }

  /// Objects count by what the map holds of them: never by unmapped voxels, whose P = 0.5 would
  /// drown everything (paper.md, trouble with eqs 18 and 19).
  void LookAtOpis(const Pose2& at, View& view) const {
    for (const OpiBelief& opi : opis_) {
      if (!Shows(at, opi.ned[0], opi.ned[1], 0)) {
        continue;
      }
      if (opi.looks > 0) {
        view.opi += kVoxelsPerOpi * Entropy(opi.probability);
      } else if (opi.prior_id >= 0) {
        view.inherited += kVoxelsPerOpi * MinusPLogP(opi.probability);
      }
    }
  }

  const Ground& ground_;
  const std::vector<OpiBelief>& opis_;
  double covered_;
  const PaperParams& params_;
  std::vector<View> views_;
};

}  // namespace

PaperPlanner::PaperPlanner(const PaperParams& params, const Region& region, Random random)
    : params_(params), region_(region), random_(random) {}

std::optional<Option> PaperPlanner::Next(const Pose2& start, const Ground& ground,
                                         const std::vector<OpiBelief>& opis, double covered) {
  PaperTree tree(start, ground, opis, covered, params_);
  for (const Pose2& view : kept_) {
    const int last = tree.Size() - 1;
    if (!tree.Add(last, ShortestDubins(tree.At(last).edge.end(), view, params_.turn_radius),
                  region_)) {
      break;
    }
  }
  const SeenDensity density(ground);
  for (int draw = 0; draw < kDrawsPerNode * params_.nodes && tree.Size() <= params_.nodes; ++draw) {
    const Pose2 sample = density.Sample(region_, random_);
    const int parent = tree.Nearest(sample);
    static_cast<void>(
        tree.Add(parent,
                 ShortestDubins(tree.At(parent).edge.end(), sample, params_.turn_radius)
                     .Prefix(params_.max_edge.value()),
                 region_));
  }
  kept_.clear();
  if (tree.Size() == 1) {
    return std::nullopt;
  }
  int best = 1;
  for (int i = 2; i < tree.Size(); ++i) {
    best = tree.LogGain(i) > tree.LogGain(best) ? i : best;
  }
  log_gain_ = tree.LogGain(best);
  const std::vector<int> branch = tree.BranchTo(best);
  for (std::size_t i = 1; i < branch.size(); ++i) {
    kept_.push_back(tree.At(branch[i]).edge.end());
  }
  return Option{.source = "paper", .path = tree.At(branch.front()).edge, .estimate = log_gain_};
}

}  // namespace limpet
