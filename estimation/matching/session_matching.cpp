// SPDX-License-Identifier: MIT
#include "estimation/matching/session_matching.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/LU>

#include "estimation/matching/assignment.hpp"

namespace limpet {
namespace {

constexpr int kRefinements = 6;  // of who is who and of the offset, in turns
constexpr int kTurns = 3;        // of the offset alone: it is not linear in the turn
constexpr std::size_t kStarts = 12, kNeighbours = 3;
/// Where another colour costs more, pairs of one colour alone propose offsets: there are enough.
constexpr double kTellingColor = 2.0;

class SessionMatcher {
 public:
  SessionMatcher(const std::vector<ObjectEstimate>& former, const std::vector<ObjectEstimate>& now,
                 const MatchingParams& params, const Eigen::Matrix4d& prior)
      : former_(former),
        now_(now),
        params_(params),
        gate_(std::pow(params.gate_sigmas, 2)),
        prior_(prior) {
    for (const ObjectEstimate& object : former_) {
      pivot_ += object.p_W.head<2>() / static_cast<double>(former_.size());
    }
  }

  [[nodiscard]] SessionMatch Solve() const {
    SessionMatch best = Best();
    best.chance = Chances(best);
    return best;
  }

  /// The offset of given matches.
  [[nodiscard]] SessionMatch Fit(FormerMatches now_of_former) const {
    SessionMatch match{.now_of_former = std::move(now_of_former)};
    FitOffset(match);
    return match;
  }

 private:
  using Pair = std::pair<std::size_t, int>;  // indices of a former and of a present object
  struct Hypothesis {
    FormerMatches now_of_former;
    double weight = 1.0;  // likelihood relative to the best
  };

  [[nodiscard]] SessionMatch Best() const {
    SessionMatch best = Refine(FrameOffset{.pivot_W = pivot_});
    double best_cost = Cost(best);
    for (const Start& start : BestStarts()) {
      const SessionMatch candidate = Refine(start.offset);
      const double cost = Cost(candidate);
      if (cost < best_cost - 1e-9) {
        best = candidate;
        best_cost = cost;
      }
    }
    return best;
  }

  /// A place to start from, and how promising it looks.
  struct Start {
    FrameOffset offset;
    double promise = 0.0;
  };

  /// Every pair alone proposes a shift, and with a neighbour a turn.
  [[nodiscard]] std::vector<Start> BestStarts() const {
    std::vector<Start> starts;
    for (const ObjectEstimate& a : former_) {
      const std::vector<const ObjectEstimate*> neighbours = NeighboursOf(a);
      for (const ObjectEstimate& b : now_) {
        if (params_.ColorCost(a, b) > kTellingColor) continue;
        FrameOffset shifted{.pivot_W = pivot_};
        shifted.shift_W = b.p_W.head<2>() - a.p_W.head<2>();
        shifted.down = DownFrom(a, b);
        AddStart(shifted, a.p_W, starts);
        for (const ObjectEstimate* neighbour : neighbours)
          AddTurned(a, b, *neighbour, starts);
      }
    }
    const auto kept = std::min<std::size_t>(starts.size(), kStarts);
    const auto more = [](const Start& x, const Start& y) { return x.promise > y.promise; };
    std::stable_sort(starts.begin(), starts.end(), more);
    starts.resize(kept);
    return starts;
  }

  [[nodiscard]] std::vector<const ObjectEstimate*> NeighboursOf(const ObjectEstimate& a) const {
    std::vector<const ObjectEstimate*> others;
    for (const ObjectEstimate& other : former_) {
      if (&other != &a) others.push_back(&other);
    }
    std::ranges::stable_sort(others, {}, [&a](const ObjectEstimate* other) {
      return (other->p_W - a.p_W).squaredNorm();
    });
    others.resize(std::min<std::size_t>(others.size(), kNeighbours));
    return others;
  }

  /// The turns that bring `a` to `b` and its neighbour to another present object.
  void AddTurned(const ObjectEstimate& a, const ObjectEstimate& b, const ObjectEstimate& neighbour,
                 std::vector<Start>& starts) const {
    const Eigen::Vector2d before = (neighbour.p_W - a.p_W).head<2>();
    for (const ObjectEstimate& c : now_) {
      const Eigen::Vector2d after = (c.p_W - b.p_W).head<2>();
      const double misfit = after.norm() - before.norm();
      if (&c == &b || params_.ColorCost(neighbour, c) > kTellingColor ||
          misfit * misfit > gate_ * params_.PairCovariance(neighbour, c).trace()) {
        continue;
      }
      FrameOffset turned{.pivot_W = pivot_};
      turned.turn = TurnBetween(before, after);
      turned.shift_W = (b.p_W - turned.Apply(a.p_W)).head<2>();
      turned.down = DownFrom(a, b);
      AddStart(turned, std::nullopt, starts);
    }
  }

  /// `pair`: the former place that alone stands for the start; its turn is not known then.
  void AddStart(const FrameOffset& offset, const std::optional<Eigen::Vector3d>& pair,
                std::vector<Start>& starts) const {
    const double improbable = PriorCost(offset);
    if (improbable > gate_) {
      return;
    }
    int near = 0;
    for (const ObjectEstimate& a : former_) {
      const Eigen::Vector2d there = offset.Apply(a.p_W).head<2>();
      const double swing = pair ? params_.turn_sigma.value() * (a.p_W - *pair).norm() : 0.0;
      const auto is_near = [&](const ObjectEstimate& b) {
        const double reach = gate_ * (params_.PairCovariance(a, b).trace() + swing * swing);
        return params_.ColorCost(a, b) <= gate_ && (b.p_W.head<2>() - there).squaredNorm() < reach;
      };
      near += std::ranges::any_of(now_, is_near) ? 1 : 0;
    }
    starts.push_back({offset, near - improbable / gate_});
  }

  /// What one pair says of the depth between the frames, weighed with the prior.
  [[nodiscard]] double DownFrom(const ObjectEstimate& a, const ObjectEstimate& b) const {
    return (b.p_W.z() - a.p_W.z()) / (1.0 + prior_(2, 2) * params_.PairCovariance(a, b)(2, 2));
  }

  [[nodiscard]] double PriorCost(const FrameOffset& offset) const {
    return offset.vector().dot(prior_ * offset.vector());
  }

  /// Squared sigmas of a pair under an offset; far beyond the gate only that it is.
  [[nodiscard]] double Distance(const ObjectEstimate& a, const ObjectEstimate& b,
                                const FrameOffset& offset) const {
    const Eigen::Vector3d error = b.p_W - offset.Apply(a.p_W);
    const Eigen::Matrix3d covariance = params_.PairCovariance(a, b);
    if (error.squaredNorm() > gate_ * covariance.trace()) {
      return kImpossibleCost;
    }
    return error.dot(covariance.inverse() * error) + params_.ColorCost(a, b);
  }

  [[nodiscard]] FormerMatches Assign(const FrameOffset& offset,
                                     const std::optional<Pair>& forbidden) const {
    Eigen::MatrixXd costs(former_.size(), now_.size());
    for (Eigen::Index i = 0; i < costs.rows(); ++i) {
      for (Eigen::Index j = 0; j < costs.cols(); ++j) {
        costs(i, j) = Distance(former_[static_cast<std::size_t>(i)],
                               now_[static_cast<std::size_t>(j)], offset);
      }
    }
    if (forbidden) {
      costs(static_cast<Eigen::Index>(forbidden->first), forbidden->second) = kImpossibleCost;
    }
    return AssignOneToOne(costs, gate_);
  }

  [[nodiscard]] SessionMatch Refine(const FrameOffset& offset,
                                    const std::optional<Pair>& forbidden = std::nullopt) const {
    SessionMatch match{.now_of_former = Assign(offset, forbidden), .offset = offset};
    for (int i = 0; i < kRefinements; ++i) {
      FitOffset(match);
      FormerMatches again = Assign(match.offset, forbidden);
      if (again == match.now_of_former) {
        return match;
      }
      match.now_of_former = std::move(again);
    }
    FitOffset(match);
    return match;
  }

  /// Least squares for (north, east, down, turn) with the priors.
  void FitOffset(SessionMatch& match) const {
    const auto matches = CountOf(match.now_of_former);
    FrameOffset offset{.pivot_W = pivot_};
    Eigen::Matrix4d covariance;
    for (int turn = 0; turn < kTurns; ++turn) {
      Eigen::Matrix4d information = prior_;
      Eigen::Vector4d pull = -prior_ * offset.vector();
      for (std::size_t i = 0; i < former_.size(); ++i) {
        const std::optional<int> j = match.now_of_former[i];
        if (!j) continue;
        const ObjectEstimate& a = former_[i];
        const ObjectEstimate& b = now_[static_cast<std::size_t>(*j)];
        Eigen::Matrix<double, 3, 4> J = offset.Jacobian(a.p_W);
        if (matches < 2) {
          J.col(3).setZero();  // one match cannot tell a turn from a shift
        }
        const Eigen::Matrix3d weight = params_.PairCovariance(a, b).inverse();
        information += J.transpose() * weight * J;
        pull += J.transpose() * weight * (b.p_W - offset.Apply(a.p_W));
      }
      covariance = information.inverse();
      offset.Move(covariance * pull);
    }
    match.offset = offset;
    match.offset_cov = covariance;
  }

  /// What a match explains less what the offset costs; lower is better.
  [[nodiscard]] double Cost(const SessionMatch& match) const {
    double cost = PriorCost(match.offset);
    for (std::size_t i = 0; i < former_.size(); ++i) {
      const std::optional<int> j = match.now_of_former[i];
      cost += j ? Distance(former_[i], now_[static_cast<std::size_t>(*j)], match.offset) : gate_;
    }
    return cost;
  }

  [[nodiscard]] static std::ptrdiff_t CountOf(const FormerMatches& now_of_former) {
    return std::ranges::count_if(now_of_former,
                                 [](const std::optional<int>& j) { return j.has_value(); });
  }

  /// True if the offset, as far as other matches than this object's pin it, may bring the two
  /// together.
  [[nodiscard]] bool MayBeOne(const SessionMatch& match, std::size_t i, int j) const {
    constexpr std::ptrdiff_t kPinned = 3;  // matches from which on one more or less does not matter
    constexpr double kWithoutIt = 4.0;     // share by which the offset's covariance then grows
    const ObjectEstimate& a = former_[i];
    const ObjectEstimate& b = now_[static_cast<std::size_t>(j)];
    const Eigen::Matrix<double, 3, 4> J = match.offset.Jacobian(a.p_W);
    const bool is_pinned = CountOf(match.now_of_former) >= kPinned;
    const Eigen::Matrix4d frame =
        is_pinned ? Eigen::Matrix4d(kWithoutIt * match.offset_cov) : prior_.inverse();
    const double reach = (params_.PairCovariance(a, b) + J * frame * J.transpose()).trace();
    return params_.ColorCost(a, b) <= gate_ &&
           (b.p_W - match.offset.Apply(a.p_W)).squaredNorm() <= gate_ * reach;
  }

  /// Offsets from which the best assignment without a pair is looked for: the other objects that
  /// one of the two may be. Empty if there is none.
  [[nodiscard]] std::vector<FrameOffset> StartsWithout(const Pair& pair,
                                                       const SessionMatch& best) const {
    std::vector<FrameOffset> starts;
    const auto add = [&](std::size_t i, int j) {
      if (!MayBeOne(best, i, j)) return;
      FrameOffset shifted = best.offset;
      shifted.shift_W +=
          (now_[static_cast<std::size_t>(j)].p_W - best.offset.Apply(former_[i].p_W)).head<2>();
      starts.push_back(shifted);
    };
    for (std::size_t i = 0; i < former_.size(); ++i) {
      if (i != pair.first) add(i, pair.second);
    }
    for (int j = 0; j < static_cast<int>(now_.size()); ++j) {
      if (j != pair.second) add(pair.first, j);
    }
    if (!starts.empty()) starts.push_back(best.offset);
    return starts;
  }

  /// The best assignment first, then distinct ones of as many matches, each the best without one of
  /// its pairs.
  [[nodiscard]] std::vector<Hypothesis> Hypotheses(const SessionMatch& best) const {
    std::vector<Hypothesis> hypotheses{{.now_of_former = best.now_of_former}};
    const double least = Cost(best);
    for (std::size_t i = 0; i < former_.size(); ++i) {
      if (!best.now_of_former[i]) continue;
      const Pair pair{i, *best.now_of_former[i]};
      Hypothesis rival{.now_of_former = {}, .weight = 0.0};
      for (const FrameOffset& start : StartsWithout(pair, best)) {
        SessionMatch match = Refine(start, pair);
        const double weight = std::exp(std::min(0.5 * (least - Cost(match)), 0.0));
        if (CountOf(match.now_of_former) == CountOf(best.now_of_former) && weight > rival.weight) {
          rival = {std::move(match.now_of_former), weight};
        }
      }
      const bool is_known = std::ranges::any_of(hypotheses, [&rival](const Hypothesis& other) {
        return other.now_of_former == rival.now_of_former;
      });
      if (rival.weight > 0.0 && !is_known) hypotheses.push_back(std::move(rival));
    }
    return hypotheses;
  }

  /// Each present object over the hypotheses that say something else of it than the best one, and
  /// that one: doubts elsewhere are none about this object.
  [[nodiscard]] Eigen::MatrixXd Chances(const SessionMatch& best) const {
    const std::vector<Hypothesis> hypotheses = Hypotheses(best);
    const auto former_of = [](const FormerMatches& now_of_former,
                              Eigen::Index j) -> std::optional<Eigen::Index> {
      const auto found = std::ranges::find(now_of_former, std::optional(static_cast<int>(j)));
      return found == now_of_former.end() ? std::nullopt
                                          : std::optional(found - now_of_former.begin());
    };
    Eigen::MatrixXd chance = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(former_.size()),
                                                   static_cast<Eigen::Index>(now_.size()));
    for (Eigen::Index j = 0; j < chance.cols(); ++j) {
      const std::optional<Eigen::Index> usual = former_of(best.now_of_former, j);
      double total = 0.0;
      for (std::size_t h = 0; h < hypotheses.size(); ++h) {
        const std::optional<Eigen::Index> i = former_of(hypotheses[h].now_of_former, j);
        if (h > 0 && i == usual) continue;
        total += hypotheses[h].weight;
        if (i) chance(*i, j) += hypotheses[h].weight;
      }
      chance.col(j) /= total;
    }
    return chance;
  }

  const std::vector<ObjectEstimate>& former_;
  const std::vector<ObjectEstimate>& now_;
  const MatchingParams& params_;
  double gate_;
  Eigen::Matrix4d prior_;
  Eigen::Vector2d pivot_ = Eigen::Vector2d::Zero();
};

}  // namespace

Eigen::Matrix4d OffsetPrior(const MatchingParams& params) {
  const double shift = std::hypot(params.offset_sigma.value(), params.datum_sigma.value());
  const double turn = std::hypot(params.turn_sigma.value(), params.datum_turn_sigma.value());
  const Eigen::Vector4d sigmas(shift, shift, params.down_sigma.value(), turn);
  return sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
}

SessionMatch MatchSessions(const std::vector<ObjectEstimate>& former,
                           const std::vector<ObjectEstimate>& now, const MatchingParams& params,
                           const Eigen::Matrix4d& prior) {
  return SessionMatcher(former, now, params, prior).Solve();
}

SessionMatch FitSessions(const std::vector<ObjectEstimate>& former,
                         const std::vector<ObjectEstimate>& now, FormerMatches now_of_former,
                         const MatchingParams& params, const Eigen::Matrix4d& prior) {
  return SessionMatcher(former, now, params, prior).Fit(std::move(now_of_former));
}

}  // namespace limpet
