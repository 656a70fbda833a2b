// SPDX-License-Identifier: MIT
#include "limpet/planning/beam_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "limpet/planning/path_valuer.hpp"

namespace limpet {
namespace {

/// Paths that leave the region on their way back into it pay this per metre and motion.
constexpr double kDeficitPrice = 5.0;
/// Share of the beam that each first motion keeps for itself, so that the offers are alternatives.
constexpr double kOpeningShare = 0.05;
/// States nearer to each other than this are one: the better stays.
constexpr double kSamePlace = 0.5;
constexpr double kSameYaw = std::numbers::pi / 12.0;

/// Where alternatives must differ [m], and by how much.
constexpr double kStemLength = 10.0;
constexpr double kOtherPlace = 1.5;
constexpr double kOtherYaw = std::numbers::pi / 6.0;

struct Node {
  Pose2 pose;
  int parent = 0;  ///< of the first node, the root, nobody asks
  double curvature = 0.0;
  int opening = 0;              ///< index of the first motion; the root has none
  Pose2 stem{};                 ///< after the first kStemLength, or as far as it has come
  bool is_alternative = false;  ///< kept for its stem: the search for the best ignores it
  double value = 0.0;
  std::size_t change_begin = 0, change_end = 0;
  std::size_t event_begin = 0, event_end = 0;  ///< of the objective, that this motion brings
};

using Bin = std::tuple<int, int, int>;

Bin BinOf(const Pose2& pose) {
  return {static_cast<int>(std::floor(pose.north / kSamePlace)),
          static_cast<int>(std::floor(pose.east / kSamePlace)),
          static_cast<int>(std::floor(WrapAngle(pose.yaw) / kSameYaw))};
}

bool AreAlternatives(const Pose2& a, const Pose2& b) {
  return Distance(a, b) > kOtherPlace || std::abs(WrapAngle(a.yaw - b.yaw)) > kOtherYaw;
}

/// Adds `stem` if it is an alternative to all of `stems`.
bool IsNewStem(const Pose2& stem, std::vector<Pose2>& stems) {
  const bool is_new =
      std::ranges::all_of(stems, [&stem](const Pose2& s) { return AreAlternatives(s, stem); });
  if (is_new) {
    stems.push_back(stem);
  }
  return is_new;
}

class Search {
 public:
  Search(const Pose2& start, const Ground& ground, const Region& region, const Objective& objective,
         const BeamParams& params)
      : region_(region),
        params_(params),
        workspace_(ground),
        valuer_(objective, ground, start, params.horizon.value()) {
    const double tight = 1.0 / params.turn_radius.value();
    curvatures_ = {0.0, -0.5 * tight, 0.5 * tight, -tight, tight};
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
      Keep(depth + 1 >= StemDepth());
    }
  }

  /// The best leaf of each stem.
  [[nodiscard]] std::vector<Option> Offers() const {
    std::vector<Option> offers;
    std::vector<Pose2> stems;
    for (const int leaf : beam_) {
      const Node& node = nodes_[static_cast<std::size_t>(leaf)];
      if (leaf == 0 || static_cast<int>(offers.size()) >= params_.offers) {
        break;
      }
      if (!IsNewStem(node.stem, stems)) {
        continue;
      }
      DubinsPath path(nodes_.front().pose);
      for (const double curvature : MotionsTo(leaf)) {
        path.Append({.curvature = curvature, .length = params_.primitive.value()});
      }
      offers.push_back({"beam", path, node.value});
    }
    return offers;
  }

 private:
  /// Motions after which alternatives must differ.
  [[nodiscard]] int StemDepth() const {
    return static_cast<int>(std::lround(kStemLength / params_.primitive.value()));
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
      Node next{.pose = Advance(from.pose, {.curvature = curvature, .length = motion.length}),
                .parent = index,
                .curvature = curvature,
                .opening = depth == 0 ? static_cast<int>(i) : from.opening,
                .stem = {},
                .is_alternative = from.is_alternative,
                .value = from.value - motion.length};
      next.stem = depth < StemDepth() ? next.pose : from.stem;
      const std::size_t events = valuer_.Mark();
      next.value += valuer_.Worth({.from = from.pose,
                                   .motion = motion,
                                   .before = depth * motion.length,
                                   .seen = workspace_.Sweep(from.pose, motion)}) -
                    kDeficitPrice * region_.Deficit(next.pose, params_.turn_radius);
      NoteEvents(events, next);
      next.change_begin = changes_.size();
      const auto changed = workspace_.changes().subspan(mark);
      changes_.insert(changes_.end(), changed.begin(), changed.end());
      next.change_end = changes_.size();
      workspace_.Rewind(mark);
      candidates_.push_back(next);
    }
  }

  void NoteEvents(std::size_t mark, Node& next) {
    next.event_begin = events_.size();
    const auto added = valuer_.EventsSince(mark);
    events_.insert(events_.end(), added.begin(), added.end());
    next.event_end = events_.size();
    valuer_.Rewind(mark);
  }

  /// Brings workspace and events to the state after the motions that lead to `index`.
  void Restore(int index) {
    workspace_.Rewind(0);
    valuer_.Rewind(0);
    chain_.clear();
    for (int i = index; i > 0; i = nodes_[static_cast<std::size_t>(i)].parent) {
      chain_.push_back(i);
    }
    for (auto i = chain_.rbegin(); i != chain_.rend(); ++i) {
      const Node& node = nodes_[static_cast<std::size_t>(*i)];
      workspace_.Replay(
          std::span(changes_).subspan(node.change_begin, node.change_end - node.change_begin));
      valuer_.Replay(
          std::span(events_).subspan(node.event_begin, node.event_end - node.event_begin));
    }
  }

  /// The best candidates become the beam, and if `with_alternatives` the best of other stems.
  void Keep(bool with_alternatives) {
    std::vector<std::size_t> order(candidates_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return candidates_[a].value > candidates_[b].value;
    });
    std::vector<bool> is_kept(order.size(), false);
    KeepBest(order, is_kept);
    if (with_alternatives) {
      KeepAlternatives(order, is_kept);
    }
    beam_.clear();
    for (const std::size_t i : order) {
      if (is_kept[i]) {
        beam_.push_back(static_cast<int>(nodes_.size()));
        nodes_.push_back(candidates_[i]);
      }
    }
  }

  /// The best candidates of `order`, one per place.
  void KeepBest(const std::vector<std::size_t>& order, std::vector<bool>& is_kept) const {
    std::vector<Bin> taken;
    const int reserved = static_cast<int>(std::lround(kOpeningShare * params_.width));
    std::array<int, 5> per_opening{};
    int kept = 0;
    const auto keep_while = [&](auto has_room) {
      for (const std::size_t i : order) {
        if (candidates_[i].is_alternative || is_kept[i] || !has_room(candidates_[i])) {
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
  }

  /// The best candidate of each stem that none of those kept stands for.
  void KeepAlternatives(const std::vector<std::size_t>& order, std::vector<bool>& is_kept) {
    std::vector<Pose2> stems;
    for (const std::size_t i : order) {
      if (is_kept[i]) {
        static_cast<void>(IsNewStem(candidates_[i].stem, stems));
      }
    }
    for (const std::size_t i : order) {
      if (static_cast<int>(stems.size()) >= params_.offers) {
        return;
      }
      if (!is_kept[i] && IsNewStem(candidates_[i].stem, stems)) {
        is_kept[i] = true;
        candidates_[i].is_alternative = true;
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
  const BeamParams& params_;
  SeenWorkspace workspace_;
  PathValuer valuer_;
  std::array<double, 5> curvatures_{};
  std::vector<Node> nodes_, candidates_;
  std::vector<int> beam_, chain_;
  std::vector<SeenWorkspace::Change> changes_;
  std::vector<std::uint32_t> events_;
};

}  // namespace

std::vector<Option> BeamSearch(const Pose2& start, const Ground& ground, const Region& region,
                               const Objective& objective, const BeamParams& params) {
  Search search(start, ground, region, objective, params);
  search.Run();
  return search.Offers();
}

}  // namespace limpet
