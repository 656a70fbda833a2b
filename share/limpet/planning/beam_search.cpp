// SPDX-License-Identifier: MIT
#include "limpet/planning/beam_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace limpet {
namespace {

/// Paths that leave the region on their way back into it pay this per metre and motion.
constexpr double kDeficitPrice = 5.0;
/// Share of the beam that each first motion keeps for itself, so that the offers are alternatives.
constexpr double kOpeningShare = 0.05;
/// States nearer to each other than this are one: the better stays.
constexpr double kSamePlace = 0.5;
constexpr double kSameYaw = std::numbers::pi / 12.0;

struct Node {
  Pose2 pose;
  int parent = -1;
  double curvature = 0.0;
  int opening = -1;  ///< index of the first motion
  double value = 0.0;
  std::size_t change_begin = 0, change_end = 0;
  std::size_t seen_begin = 0, seen_end = 0;  ///< targets that this motion is the first to see
};

using Bin = std::tuple<int, int, int>;

Bin BinOf(const Pose2& pose) {
  return {static_cast<int>(std::floor(pose.north / kSamePlace)),
          static_cast<int>(std::floor(pose.east / kSamePlace)),
          static_cast<int>(std::floor(WrapAngle(pose.yaw) / kSameYaw))};
}

class Search {
 public:
  Search(const Pose2& start, const Ground& ground, const Region& region, const Objective& objective,
         const BeamParams& params)
      : region_(region),
        objective_(objective),
        params_(params),
        workspace_(ground),
        swath_(ground.swath()) {
    const double tight = 1.0 / params.turn_radius.value();
    curvatures_ = {0.0, -0.5 * tight, 0.5 * tight, -tight, tight};
    FindTargetsInReach(start);
    nodes_.push_back({.pose = start});
    beam_.push_back(0);
  }

  void Run() {
    const int depths = std::max(
        1, static_cast<int>(std::lround(params_.horizon.value() / params_.primitive.value())));
    for (int depth = 0; depth < depths; ++depth) {
      candidates_.clear();
      for (const int node : beam_) {
        Expand(node, depth);
      }
      if (candidates_.empty()) {
        return;
      }
      Keep();
    }
  }

  /// The best leaf of each first motion.
  [[nodiscard]] std::vector<Option> Offers() const {
    std::vector<Option> offers;
    std::array<bool, 5> is_offered{};
    for (const int leaf : beam_) {
      if (leaf == 0 || static_cast<int>(offers.size()) >= params_.offers) {
        break;
      }
      const Node& node = nodes_[static_cast<std::size_t>(leaf)];
      if (is_offered[static_cast<std::size_t>(node.opening)]) {
        continue;
      }
      is_offered[static_cast<std::size_t>(node.opening)] = true;
      DubinsPath path(nodes_.front().pose);
      for (const double curvature : MotionsTo(leaf)) {
        path.Append({.curvature = curvature, .length = params_.primitive.value()});
      }
      offers.push_back({"beam", path, node.value});
    }
    return offers;
  }

 private:
  /// Of many targets a horizon's length shows few: the rest costs nothing.
  void FindTargetsInReach(const Pose2& start) {
    for (const Target& target : objective_.targets) {
      const double reach =
          params_.horizon.value() + target.window.half_along + target.window.half_across;
      if (std::hypot(target.north - start.north, target.east - start.east) <= reach) {
        targets_.push_back(target);
      }
    }
    is_seen_.resize(targets_.size());
  }

  void Expand(int index, int depth) {
    Restore(index);
    const std::size_t mark = workspace_.Mark();
    const Node from = nodes_[static_cast<std::size_t>(index)];
    for (std::size_t i = 0; i < curvatures_.size(); ++i) {
      const double curvature = curvatures_[i];
      const PathSegment motion{.curvature = curvature, .length = params_.primitive.value()};
      if (!region_.Allows(from.pose, motion, params_.turn_radius)) {
        continue;
      }
      Node next{.pose = Advance(from.pose, curvature, motion.length),
                .parent = index,
                .curvature = curvature,
                .opening = depth == 0 ? static_cast<int>(i) : from.opening,
                .value = from.value - motion.length};
      const NewSight gain = workspace_.Sweep(from.pose, motion);
      next.value += objective_.w_cover * gain.new_area / swath_ -
                    objective_.w_frontier * gain.frontier_growth -
                    kDeficitPrice * region_.Deficit(next.pose, params_.turn_radius);
      SeeTargets(from.pose, motion, depth * motion.length, next);
      next.change_begin = changes_.size();
      const auto changed = workspace_.changes().subspan(mark);
      changes_.insert(changes_.end(), changed.begin(), changed.end());
      next.change_end = changes_.size();
      workspace_.Rewind(mark);
      candidates_.push_back(next);
    }
  }

  /// Brings workspace and seen targets to the state after the motions that lead to `index`.
  void Restore(int index) {
    workspace_.Rewind(0);
    std::fill(is_seen_.begin(), is_seen_.end(), false);
    chain_.clear();
    for (int i = index; i > 0; i = nodes_[static_cast<std::size_t>(i)].parent) {
      chain_.push_back(i);
    }
    for (auto i = chain_.rbegin(); i != chain_.rend(); ++i) {
      const Node& node = nodes_[static_cast<std::size_t>(*i)];
      workspace_.Replay(
          std::span(changes_).subspan(node.change_begin, node.change_end - node.change_begin));
      for (std::size_t k = node.seen_begin; k < node.seen_end; ++k) {
        is_seen_[seen_[k]] = true;
      }
    }
  }

  void SeeTargets(const Pose2& from, const PathSegment& motion, double s_before, Node& next) {
    next.seen_begin = seen_.size();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const Target& target = targets_[i];
      for (double s = SightWorkspace::kStep; !is_seen_[i] && s <= motion.length + 1e-9;
           s += SightWorkspace::kStep) {
        if (target.IsSeenFrom(Advance(from, motion.curvature, s))) {
          seen_.push_back(i);
          next.value +=
              target.value * std::max(0.0, 1.0 - (s_before + s) / objective_.target_decay_m);
          break;
        }
      }
    }
    next.seen_end = seen_.size();
  }

  /// The best candidates, one per place, become the beam.
  void Keep() {
    std::vector<std::size_t> order(candidates_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return candidates_[a].value > candidates_[b].value;
    });
    std::vector<Bin> taken;
    std::vector<bool> is_kept(order.size(), false);
    const int reserved = static_cast<int>(std::lround(kOpeningShare * params_.width));
    std::array<int, 5> per_opening{};
    int kept = 0;
    const auto keep_while = [&](auto has_room) {
      for (const std::size_t i : order) {
        if (is_kept[i] || !has_room(candidates_[i])) {
          continue;
        }
        const Bin bin = BinOf(candidates_[i].pose);
        const auto place = std::lower_bound(taken.begin(), taken.end(), bin);
        if (place == taken.end() || *place != bin) {
          taken.insert(place, bin);
          is_kept[i] = true;
          ++kept;
          ++per_opening[static_cast<std::size_t>(candidates_[i].opening)];
        }
      }
    };
    keep_while([&](const Node& node) {
      return per_opening[static_cast<std::size_t>(node.opening)] < reserved;
    });
    keep_while([&](const Node&) { return kept < params_.width; });
    beam_.clear();
    for (const std::size_t i : order) {
      if (is_kept[i]) {
        beam_.push_back(static_cast<int>(nodes_.size()));
        nodes_.push_back(candidates_[i]);
      }
    }
  }

  [[nodiscard]] std::vector<double> MotionsTo(int leaf) const {
    std::vector<double> motions;
    for (int i = leaf; i > 0; i = nodes_[static_cast<std::size_t>(i)].parent) {
      motions.push_back(nodes_[static_cast<std::size_t>(i)].curvature);
    }
    std::reverse(motions.begin(), motions.end());
    return motions;
  }

  const Region& region_;
  const Objective& objective_;
  const BeamParams& params_;
  SightWorkspace workspace_;
  double swath_;
  std::array<double, 5> curvatures_{};
  std::vector<Target> targets_;  ///< those in reach
  std::vector<bool> is_seen_;    ///< of these, by the motions up to the node at hand
  std::vector<std::size_t> seen_;
  std::vector<Node> nodes_, candidates_;
  std::vector<int> beam_, chain_;
  std::vector<SightWorkspace::Change> changes_;
};

}  // namespace

std::vector<Option> BeamSearch(const Pose2& start, const Ground& ground, const Region& region,
                               const Objective& objective, const BeamParams& params) {
  Search search(start, ground, region, objective, params);
  search.Run();
  return search.Offers();
}

}  // namespace limpet
