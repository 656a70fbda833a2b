// SPDX-License-Identifier: MIT
#include "limpet/planning/paper_tree.hpp"

#include <algorithm>
#include <utility>

#include "limpet/planning/seen_density.hpp"

namespace limpet {
namespace {

/// A shorter motion is none [m].
constexpr double kShortestEdge = 1.0;

struct TracedView {
  DubinsPath edge;  ///< from the parent; its end is the view
  int parent = 0;   ///< of the first view, the root, nobody asks
};

class Tree {
 public:
  Tree(const Pose2& start, const Region& region, Meters turn_radius)
      : region_(region), turn_radius_(turn_radius) {
    views_.push_back({.edge = DubinsPath(start)});
  }

  [[nodiscard]] int Size() const { return static_cast<int>(views_.size()); }
  [[nodiscard]] Pose2 PoseOf(int i) const { return At(i).edge.end(); }

  [[nodiscard]] int Nearest(const Pose2& sample) const {
    int nearest = 0;
    for (int i = 1; i < Size(); ++i) {
      if (Distance(PoseOf(i), sample) < Distance(PoseOf(nearest), sample)) {
        nearest = i;
      }
    }
    return nearest;
  }

  /// Adds a view at the end of `edge`; false if the motion is none or leaves the region.
  bool Add(int parent, DubinsPath edge) {
    if (edge.length() < kShortestEdge || !region_.Contains(edge) ||
        !region_.IsRecoverable(edge.end(), turn_radius_)) {
      return false;
    }
    views_.push_back({.edge = std::move(edge), .parent = parent});
    return true;
  }

  [[nodiscard]] Option OptionOf(int leaf) const {
    Option option{.source = "paper", .path = {}, .views = {}};
    int first = leaf;
    for (int i = leaf; i > 0; i = At(i).parent) {
      option.views.push_back(PoseOf(i));
      first = i;
    }
    std::ranges::reverse(option.views);
    option.path = At(first).edge;
    return option;
  }

 private:
  [[nodiscard]] const TracedView& At(int i) const { return views_[static_cast<std::size_t>(i)]; }

  const Region& region_;
  Meters turn_radius_;
  std::vector<TracedView> views_;
};

}  // namespace

std::vector<Option> PaperTree(const Pose2& start, const std::vector<Pose2>& kept,
                              const Ground& ground, const Region& region,
                              const PaperTreeParams& params, Random& random) {
  Tree tree(start, region, params.turn_radius);
  for (const Pose2& view : kept) {
    const int last = tree.Size() - 1;
    if (!tree.Add(last, ShortestDubins(tree.PoseOf(last), view, params.turn_radius))) {
      break;
    }
  }
  const SeenDensity density(ground);
  for (int draw = 0; draw < kDrawsPerNode * params.nodes && tree.Size() <= params.nodes; ++draw) {
    const Pose2 sample = density.Sample(region, random);
    const int parent = tree.Nearest(sample);
    static_cast<void>(
        tree.Add(parent, ShortestDubins(tree.PoseOf(parent), sample, params.turn_radius)
                             .Prefix(params.max_edge.value())));
  }
  std::vector<Option> options;
  for (int i = 1; i < tree.Size(); ++i) {
    options.push_back(tree.OptionOf(i));
  }
  return options;
}

}  // namespace limpet
