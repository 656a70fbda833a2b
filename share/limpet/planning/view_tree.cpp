// SPDX-License-Identifier: MIT
#include "limpet/planning/view_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "limpet/planning/motion_hash.hpp"
#include "limpet/planning/path_valuer.hpp"

namespace limpet {
namespace {

struct TreeView {
  DubinsPath edge;                             ///< from the parent; its end is the view
  int parent = 0;                              ///< of the first view, the root, nobody asks
  double value = 0.0;                          ///< objective of the whole branch up to here [m]
  double length = 0.0;                         ///< of the whole branch [m]
  std::vector<SeenWorkspace::Change> changes;  ///< what the edge shows beyond its ancestors
  std::vector<std::uint32_t> events;           ///< of the objective, that the edge brings
};

class Tree {
 public:
  Tree(const Pose2& start, const Ground& ground, const Region& region, const Objective& objective,
       const ViewTreeParams& params)
      : region_(region),
        params_(params),
        workspace_(ground),
        valuer_(objective, ground, start, params.nodes * params.max_edge.value()) {
    TreeView root;
    root.edge = DubinsPath(start);
    views_.push_back(std::move(root));
  }

  void Grow(const SeenDensity& density, Random& random) {
    for (int draw = 0; draw < kDrawsPerNode * params_.nodes && Size() <= params_.nodes; ++draw) {
      if (Add(density.Sample(region_, random)) && params_.rewire_radius.value() > 0.0) {
        Rewire(Size() - 1);
      }
    }
  }

  /// Best branches with different first views.
  [[nodiscard]] std::vector<Option> Offers() const {
    std::vector<int> order;
    for (int i = 1; i < Size(); ++i) {
      order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [this](int a, int b) { return At(a).value > At(b).value; });
    std::vector<Option> offers;
    std::vector<int> openings;
    for (const int leaf : order) {
      const std::vector<int> branch = BranchTo(leaf);
      if (static_cast<int>(offers.size()) >= params_.offers ||
          std::find(openings.begin(), openings.end(), branch.front()) != openings.end()) {
        continue;
      }
      openings.push_back(branch.front());
      DubinsPath path(views_.front().edge.start());
      for (const int view : branch) {
        path.Append(At(view).edge);
      }
      // Ways to many places that are far behind begin alike, and are cut before they part.
      const bool is_offered = std::ranges::any_of(offers, [&path](const Option& other) {
        return IsSame(other.path.end(), path.end()) && other.path.length() == path.length();
      });
      if (is_offered) continue;
      offers.push_back(
          {.source = "view_tree", .path = std::move(path), .estimate = At(leaf).value});
    }
    return offers;
  }

 private:
  [[nodiscard]] int Size() const { return static_cast<int>(views_.size()); }
  [[nodiscard]] const TreeView& At(int i) const { return views_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] TreeView& At(int i) { return views_[static_cast<std::size_t>(i)]; }

  /// Root excluded, first view first.
  [[nodiscard]] std::vector<int> BranchTo(int leaf) const {
    std::vector<int> branch;
    for (int i = leaf; i > 0; i = At(i).parent) {
      branch.push_back(i);
    }
    std::reverse(branch.begin(), branch.end());
    return branch;
  }

  /// REQUIRES: a candidate that is not the root.
  [[nodiscard]] bool IsAncestor(int candidate, int of) const {
    for (int i = of; i > 0; i = At(i).parent) {
      if (i == candidate) {
        return true;
      }
    }
    return false;
  }

  /// Extends the nearest view towards `sample`, by at most the longest edge.
  bool Add(const Pose2& sample) {
    int nearest = 0;
    for (int i = 1; i < Size(); ++i) {
      if (Distance(At(i).edge.end(), sample) < Distance(At(nearest).edge.end(), sample)) {
        nearest = i;
      }
    }
    const DubinsPath edge = ShortestDubins(At(nearest).edge.end(), sample, params_.turn_radius)
                                .Prefix(params_.max_edge.value());
    if (!IsFlyable(edge)) {
      return false;
    }
    TreeView view;
    view.edge = edge;
    view.parent = nearest;
    views_.push_back(std::move(view));
    Evaluate(Size() - 1);
    return true;
  }

  [[nodiscard]] bool IsFlyable(const DubinsPath& edge) const {
    return edge.length() > SeenWorkspace::kStep &&
           edge.length() <= params_.max_edge.value() + 1e-9 && region_.Contains(edge) &&
           region_.IsRecoverable(edge.end(), params_.turn_radius);
  }

  /// Value of the branch up to `index`, whose parent is up to date.
  void Evaluate(int index) {
    workspace_.Rewind(0);
    valuer_.Rewind(0);
    for (const int view : BranchTo(At(index).parent)) {
      workspace_.Replay(At(view).changes);
      valuer_.Replay(At(view).events);
    }
    const std::size_t changes = workspace_.Mark(), events = valuer_.Mark();
    TreeView& view = At(index);
    const TreeView& parent = At(view.parent);
    view.value = parent.value;
    view.length = parent.length;
    Pose2 from = view.edge.start();
    for (const PathSegment& segment : view.edge.segments()) {
      view.value += valuer_.Worth({.from = from,
                                   .motion = segment,
                                   .before = view.length,
                                   .seen = workspace_.Sweep(from, segment)}) -
                    segment.length;
      view.length += segment.length;
      from = Advance(from, segment);
    }
    const auto changed = workspace_.changes().subspan(changes);
    view.changes.assign(changed.begin(), changed.end());
    const auto happened = valuer_.EventsSince(events);
    view.events.assign(happened.begin(), happened.end());
  }

  /// Hangs views near `index` below it where that makes their branch worth more. Every view below a
  /// moved one is valued again, because what its ancestors show has changed.
  void Rewire(int index) {
    for (int near = 1; near < Size(); ++near) {
      const Pose2 end = At(index).edge.end();
      if (near == index || IsAncestor(near, index) ||
          Distance(At(near).edge.end(), end) > params_.rewire_radius.value()) {
        continue;
      }
      DubinsPath edge = ShortestDubins(end, At(near).edge.end(), params_.turn_radius);
      if (!IsFlyable(edge)) {
        continue;
      }
      TreeView before = At(near);
      At(near).edge = std::move(edge);
      At(near).parent = index;
      Evaluate(near);
      if (At(near).value > before.value) {
        EvaluateBelow(near);
      } else {
        At(near) = std::move(before);
      }
    }
  }

  void EvaluateBelow(int index) {
    for (int i = 1; i < Size(); ++i) {
      if (At(i).parent == index) {
        Evaluate(i);
        EvaluateBelow(i);
      }
    }
  }

  const Region& region_;
  const ViewTreeParams& params_;
  SeenWorkspace workspace_;
  PathValuer valuer_;
  std::vector<TreeView> views_;
};

}  // namespace

std::vector<Option> ViewTree(const Pose2& start, const Ground& ground, const Region& region,
                             const Objective& objective, const ViewTreeParams& params,
                             Random& random) {
  Tree tree(start, ground, region, objective, params);
  tree.Grow(SeenDensity(ground), random);
  return tree.Offers();
}

}  // namespace limpet
