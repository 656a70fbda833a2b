// SPDX-License-Identifier: MIT
#include "limpet/planning/pass_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "limpet/planning/pass_tour.hpp"

namespace limpet {
namespace {

constexpr std::size_t kMostExact = 12;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Of pass i: node 2 i as it is, node 2 i + 1 the other way.
class ExactOrder {
 public:
  ExactOrder(const TourJudge& judge, const Pose2& start, const std::vector<Pass>& passes)
      : judge_(judge), start_(start) {
    for (const Pass& pass : passes) {
      nodes_.push_back(pass);
      nodes_.push_back(pass.Reversed());
    }
    sets_ = std::size_t{1} << passes.size();
    leg_.assign(nodes_.size() * nodes_.size(), kInfinite);
    for (std::size_t from = 0; from < nodes_.size(); ++from) {
      for (std::size_t to = 0; to < nodes_.size(); ++to) {
        if (from / 2 != to / 2 && Leg(from, to) == kInfinite) FillLeg(from, to);
      }
    }
  }

  SurveyTour Solve() {
    const std::size_t count = nodes_.size();
    best_.assign(sets_ * count, kInfinite);
    came_from_.assign(sets_ * count, 0);
    for (std::size_t node = 0; node < count; ++node) {
      Best(std::size_t{1} << (node / 2), node) =
          PriceOfLink(start_, nodes_[node]) + nodes_[node].length;
    }
    for (std::size_t set = 1; set < sets_; ++set) {
      for (std::size_t last = 0; last < count; ++last) {
        if (Best(set, last) < kInfinite) GoOn(set, last);
      }
    }
    return Trace();
  }

 private:
  static std::size_t OtherWay(std::size_t node) { return node ^ 1U; }
  double& Leg(std::size_t from, std::size_t to) { return leg_[from * nodes_.size() + to]; }
  double& Best(std::size_t set, std::size_t last) { return best_[set * nodes_.size() + last]; }

  [[nodiscard]] double PriceOfLink(const Pose2& from, const Pass& to) const {
    return LinkBetween(from, to.in, judge_.region(), judge_.turn_radius()).Price();
  }

  /// And its leg the other way round: that link is this one flown backwards.
  void FillLeg(std::size_t from, std::size_t to) {
    const double price = PriceOfLink(nodes_[from].out(), nodes_[to]);
    Leg(from, to) = price + nodes_[to].length;
    Leg(OtherWay(to), OtherWay(from)) = price + nodes_[from].length;
  }

  void GoOn(std::size_t set, std::size_t last) {
    const double so_far = Best(set, last);
    for (std::size_t next = 0; next < nodes_.size(); ++next) {
      const std::size_t bit = std::size_t{1} << (next / 2);
      if ((set & bit) != 0) continue;
      const double cost = so_far + Leg(last, next);
      if (cost < Best(set | bit, next)) {
        Best(set | bit, next) = cost;
        came_from_[(set | bit) * nodes_.size() + next] = static_cast<std::uint8_t>(last);
      }
    }
  }

  SurveyTour Trace() {
    std::size_t set = sets_ - 1, last = 0;
    double least = kInfinite;
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const Pose2 out = nodes_[node].out();
      const double cost = Best(set, node) + std::hypot(out.north - judge_.goal().home_W.x(),
                                                       out.east - judge_.goal().home_W.y());
      if (cost < least) least = cost, last = node;
    }
    SurveyTour tour;
    while (set != 0) {
      tour.push_back(nodes_[last]);
      const std::size_t before = came_from_[set * nodes_.size() + last];
      set &= ~(std::size_t{1} << (last / 2));
      last = before;
    }
    std::reverse(tour.begin(), tour.end());
    return tour;
  }

  const TourJudge& judge_;
  Pose2 start_;
  std::vector<Pass> nodes_;
  std::size_t sets_ = 0;
  std::vector<double> leg_, best_;
  std::vector<std::uint8_t> came_from_;
};

}  // namespace

SurveyTour InBestOrder(const TourJudge& judge, const Pose2& start,
                       const std::vector<Pass>& passes) {
  if (passes.empty()) return {};
  if (passes.size() <= kMostExact) return ExactOrder(judge, start, passes).Solve();
  std::vector<Stop> stops;
  for (const Pass& pass : passes)
    stops.push_back({pass, pass.Reversed()});
  const PassTour found = PlanPassTour(start, stops, judge.region(), judge.turn_radius());
  SurveyTour tour;
  for (std::size_t i = 0; i < found.order.size(); ++i) {
    const Stop& stop = stops[found.order[i]];
    tour.push_back(stop[found.passes[i]]);
  }
  return tour;
}

}  // namespace limpet
