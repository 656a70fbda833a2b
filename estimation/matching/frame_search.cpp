// SPDX-License-Identifier: MIT
#include "estimation/matching/frame_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "estimation/matching/match_evidence.hpp"

namespace limpet {
namespace {

constexpr std::size_t kPairsEach = 10;  // per former object: half of its neighbours may be gone
constexpr double kLeastApart_m = 2.0;   // or the pair says little of a turn
constexpr std::size_t kMostVotes = 200'000;  // looks at a former object: some five milliseconds
constexpr std::size_t kRefined = 6;
// Natural logarithms. Among thirty objects each that have nothing in common, a frame comes to 7.5
// in one case of a hundred, among fourteen to 4.5; five that stayed come to more than that.
constexpr double kRelated = 7.0;   // at least, for a frame to be one
constexpr double kLikelier = 3.0;  // than any other frame
constexpr double kSame_m = 2.0;    // frames that put the objects closer to each other are one

class FrameSearch {
 public:
  FrameSearch(const std::vector<ObjectEstimate>& former, const std::vector<ObjectEstimate>& now,
              const MatchingParams& params, const FrameSearchParams& search)
      : former_(former), now_(now), params_(params), search_(search) {
    for (const ObjectEstimate& object : former_)
      pivot_ += object.p_W.head<2>() / static_cast<double>(former_.size());
    for (std::size_t i = 0; i < now_.size(); ++i)
      by_north_.push_back(i);
    std::ranges::stable_sort(by_north_, {}, [&](std::size_t i) { return now_[i].p_W.x(); });
  }

  [[nodiscard]] std::optional<FoundFrame> Best() {
    Propose();
    std::ranges::stable_sort(proposals_, std::greater{}, &Proposal::votes);
    std::vector<FoundFrame> found;
    for (const Proposal& proposal : proposals_) {
      if (found.size() >= kRefined) break;
      if (IsNew(proposal.offset, found)) found.push_back(Refined(proposal.offset));
    }
    std::ranges::stable_sort(found, std::greater{}, &FoundFrame::evidence);
    if (found.empty() || found.front().evidence < kRelated) return std::nullopt;
    const FoundFrame& best = found.front();
    for (std::size_t i = 1; i < found.size(); ++i) {
      const bool is_rival = found[i].evidence > best.evidence - kLikelier;
      if (is_rival && !AreSame(found[i].offset, best.offset)) return std::nullopt;
    }
    return best;
  }

 private:
  struct Proposal {
    FrameOffset offset;
    int votes = 0;
  };

  /// One former object, and one of its neighbours.
  struct FormerPair {
    const ObjectEstimate* a;
    const ObjectEstimate* b;
  };

  [[nodiscard]] double ReachOf(const ObjectEstimate& a, const ObjectEstimate& b) const {
    const double variance = params_.PairCovariance(a, b).topLeftCorner<2, 2>().trace();
    return params_.gate_sigmas * std::sqrt(variance);
  }

  [[nodiscard]] std::vector<FormerPair> Pairs() const {
    std::vector<FormerPair> pairs;
    for (const ObjectEstimate& a : former_) {
      std::vector<FormerPair> own;
      for (const ObjectEstimate& b : former_) {
        if ((a.p_W - b.p_W).head<2>().norm() > kLeastApart_m) own.push_back({&a, &b});
      }
      std::ranges::stable_sort(own, {}, [](const FormerPair& pair) {
        return (pair.a->p_W - pair.b->p_W).head<2>().squaredNorm();
      });
      own.resize(std::min(own.size(), kPairsEach));
      pairs.insert(pairs.end(), own.begin(), own.end());
    }
    return pairs;
  }

  void Propose() {
    const std::vector<FormerPair> pairs = Pairs();
    const std::size_t most = kMostVotes / std::max<std::size_t>(former_.size(), 1);
    // Pairs of all parts of the area have their turn before the votes are spent.
    constexpr std::size_t kStride = 7;
    for (std::size_t first = 0; first < kStride; ++first) {
      for (std::size_t i = first; i < pairs.size() && proposals_.size() < most; i += kStride)
        ProposeFrom(pairs[i]);
    }
  }

  void ProposeFrom(const FormerPair& pair) {
    const Eigen::Vector2d before = (pair.b->p_W - pair.a->p_W).head<2>();
    for (const ObjectEstimate& a : now_) {
      if (a.color != pair.a->color) continue;
      for (const ObjectEstimate& b : now_) {
        const Eigen::Vector2d after = (b.p_W - a.p_W).head<2>();
        const bool fits = &a != &b && b.color == pair.b->color &&
                          std::abs(after.norm() - before.norm()) < ReachOf(*pair.b, b);
        if (!fits) continue;
        FrameOffset offset{.pivot_W = pivot_};
        offset.turn = TurnBetween(before, after);
        if (std::abs(offset.turn) > search_.turn.value()) continue;
        // Half way between the two pairs' middles: neither object decides alone.
        const Eigen::Vector3d middle = 0.5 * (pair.a->p_W + pair.b->p_W);
        offset.shift_W = (0.5 * (a.p_W + b.p_W) - offset.Apply(middle)).head<2>();
        if (offset.shift_W.norm() > search_.radius_m) continue;
        proposals_.push_back({offset, VotesFor(offset)});
      }
    }
  }

  [[nodiscard]] int VotesFor(const FrameOffset& offset) const {
    int votes = 0;
    for (const ObjectEstimate& object : former_)
      votes += HasOneAt(object, offset.Apply(object.p_W).head<2>()) ? 1 : 0;
    return votes;
  }

  /// An object of now like the former one, where that would be.
  [[nodiscard]] bool HasOneAt(const ObjectEstimate& former, const Eigen::Vector2d& place) const {
    const double own = ReachOf(former, {});
    const auto north = [&](std::size_t i) { return now_[i].p_W.x(); };
    constexpr double kWidest_m = 3.0;  // that an object of now adds to the reach
    const double least = place.x() - own - kWidest_m;
    for (auto at = std::ranges::lower_bound(by_north_, least, {}, north); at != by_north_.end();
         ++at) {
      const ObjectEstimate& object = now_[*at];
      if (object.p_W.x() > place.x() + own + kWidest_m) return false;
      const double reach = ReachOf(former, object);
      const bool is_there = (object.p_W.head<2>() - place).squaredNorm() < reach * reach;
      if (is_there && object.color == former.color) return true;
    }
    return false;
  }

  [[nodiscard]] bool AreSame(const FrameOffset& x, const FrameOffset& y) const {
    return std::ranges::all_of(former_, [&](const ObjectEstimate& object) {
      return (x.Apply(object.p_W) - y.Apply(object.p_W)).head<2>().norm() < kSame_m;
    });
  }

  [[nodiscard]] bool IsNew(const FrameOffset& offset, const std::vector<FoundFrame>& found) const {
    return std::ranges::none_of(
        found, [&](const FoundFrame& other) { return AreSame(other.offset, offset); });
  }

  /// The offset by all its matches.
  [[nodiscard]] FoundFrame Refined(const FrameOffset& proposal) const {
    MatchingParams near = params_;  // a pair alone may be off by so much
    near.offset_sigma = Meters(1.0), near.turn_sigma = Radians::FromTextUnit(5.0);
    const std::vector<ObjectEstimate> moved = Moved(former_, proposal);
    const SessionMatch match = MatchSessions(moved, now_, near);
    const FramePrior unknown = FramePrior::Unknown(search_.radius_m, search_.turn);
    return {Together(proposal, match.offset), MatchEvidence(moved, now_, match, params_, unknown)};
  }

  const std::vector<ObjectEstimate>& former_;
  const std::vector<ObjectEstimate>& now_;
  const MatchingParams& params_;
  const FrameSearchParams& search_;
  Eigen::Vector2d pivot_ = Eigen::Vector2d::Zero();
  std::vector<std::size_t> by_north_;
  std::vector<Proposal> proposals_;
};

}  // namespace

std::vector<ObjectEstimate> Moved(std::vector<ObjectEstimate> objects, const FrameOffset& offset) {
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(offset.turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (ObjectEstimate& object : objects) {
    object.p_W = offset.Apply(object.p_W);
    object.cov_W = (R * object.cov_W * R.transpose()).eval();
  }
  return objects;
}

std::optional<FoundFrame> SearchFrame(const std::vector<ObjectEstimate>& former,
                                      const std::vector<ObjectEstimate>& now,
                                      const MatchingParams& params,
                                      const FrameSearchParams& search) {
  constexpr std::size_t kFewest = 3;  // that can agree by more than chance
  if (former.size() < kFewest || now.size() < kFewest) return std::nullopt;
  return FrameSearch(former, now, params, search).Best();
}

}  // namespace limpet
