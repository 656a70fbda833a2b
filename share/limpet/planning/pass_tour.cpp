// SPDX-License-Identifier: MIT
#include "limpet/planning/pass_tour.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace limpet {
namespace {

constexpr int kRounds = 6;
constexpr std::size_t kLongestMove = 3;
constexpr double kUnknown = -1.0;

class Salesman {
 public:
  Salesman(const Pose2& start, const std::vector<Stop>& stops, const Region& region,
           Meters turn_radius)
      : start_(start), stops_(stops), region_(region), turn_radius_(turn_radius) {
    for (const Stop& stop : stops) {
      first_pass_.push_back(pass_count_);
      pass_count_ += stop.size();
      is_either_way_.push_back(stop.size() == 2 && stop[1] == stop[0].Reversed());
    }
    cost_.assign((pass_count_ + 1) * pass_count_, kUnknown);
    for (std::size_t to = 0; to < stops.size(); ++to) {
      for (std::size_t b = 0; b < stops[to].size(); ++b) {
        Cost(pass_count_, first_pass_[to] + b) =
            PriceOfLink(start, stops[to][b]) + stops[to][b].length;
        FillFrom(to, b);
      }
    }
  }

  PassTour Solve() {
    std::vector<std::size_t> order = NearestNeighbour();
    double length = Length(order);
    for (int round = 0; round < kRounds; ++round) {
      if (!ImproveByReversal(order, length) && !ImproveByMove(order, length)) {
        break;
      }
    }
    return Build(order);
  }

 private:
  double& Cost(std::size_t from, std::size_t to) { return cost_[from * pass_count_ + to]; }

  void FillFrom(std::size_t to, std::size_t b) {
    for (std::size_t from = 0; from < stops_.size(); ++from) {
      for (std::size_t a = 0; from != to && a < stops_[from].size(); ++a) {
        double& cost = Cost(first_pass_[from] + a, first_pass_[to] + b);
        if (cost != kUnknown) continue;
        const double price = PriceOfLink(stops_[from][a].out(), stops_[to][b]);
        cost = price + stops_[to][b].length;
        if (!is_either_way_[from] || !is_either_way_[to]) continue;
        // Flown backwards, it links the two passes the other way round.
        Cost(first_pass_[to] + 1 - b, first_pass_[from] + 1 - a) = price + stops_[from][a].length;
      }
    }
  }

  [[nodiscard]] double PriceOfLink(const Pose2& from, const Pass& to) const {
    return LinkBetween(from, to.in, region_, turn_radius_).Price();
  }

  std::vector<std::size_t> NearestNeighbour() {
    std::vector<std::size_t> order;
    std::vector<bool> is_done(stops_.size(), false);
    std::size_t at = pass_count_;
    while (order.size() < stops_.size()) {
      std::size_t best_stop = 0, best_pass = 0;
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t stop = 0; stop < stops_.size(); ++stop) {
        for (std::size_t b = 0; !is_done[stop] && b < stops_[stop].size(); ++b) {
          const double cost = Cost(at, first_pass_[stop] + b);
          if (cost < best) {
            best = cost, best_stop = stop, best_pass = first_pass_[stop] + b;
          }
        }
      }
      is_done[best_stop] = true;
      order.push_back(best_stop);
      at = best_pass;
    }
    return order;
  }

  /// Length with the best pass of each stop: a shortest path through layers.
  double Length(const std::vector<std::size_t>& order) {
    before_.assign(1, 0.0);
    std::size_t from_first = pass_count_;
    for (const std::size_t stop : order) {
      now_.assign(stops_[stop].size(), std::numeric_limits<double>::infinity());
      for (std::size_t a = 0; a < before_.size(); ++a) {
        for (std::size_t b = 0; b < now_.size(); ++b) {
          now_[b] = std::min(now_[b], before_[a] + Cost(from_first + a, first_pass_[stop] + b));
        }
      }
      before_.swap(now_);
      from_first = first_pass_[stop];
    }
    return *std::min_element(before_.begin(), before_.end());
  }

  bool Accept(std::vector<std::size_t>& order, double& length,
              const std::vector<std::size_t>& trial) {
    const double trial_length = Length(trial);
    if (trial_length >= length - 1e-6) {
      return false;
    }
    order = trial;
    length = trial_length;
    return true;
  }

  bool ImproveByReversal(std::vector<std::size_t>& order, double& length) {
    bool is_better = false;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        trial_ = order;
        std::reverse(trial_.begin() + static_cast<std::ptrdiff_t>(i),
                     trial_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        is_better = Accept(order, length, trial_) || is_better;
      }
    }
    return is_better;
  }

  bool ImproveByMove(std::vector<std::size_t>& order, double& length) {
    bool is_better = false;
    for (std::size_t run = 1; run <= std::min(kLongestMove, order.size()); ++run) {
      for (std::size_t i = 0; i + run <= order.size(); ++i) {
        for (std::size_t to = 0; to + run <= order.size(); ++to) {
          if (to == i) {
            continue;
          }
          trial_ = order;
          const auto first = trial_.begin() + static_cast<std::ptrdiff_t>(i);
          const auto last = first + static_cast<std::ptrdiff_t>(run);
          const auto place = trial_.begin() + static_cast<std::ptrdiff_t>(to);
          if (to < i) {
            std::rotate(place, first, last);
          } else {
            std::rotate(first, last, place + static_cast<std::ptrdiff_t>(run));
          }
          is_better = Accept(order, length, trial_) || is_better;
        }
      }
    }
    return is_better;
  }

  /// The passes that Length chose, as a path.
  PassTour Build(const std::vector<std::size_t>& order) {
    std::vector<std::vector<std::size_t>> came_from;
    std::vector<double> before(1, 0.0);
    std::size_t from_first = pass_count_;
    for (const std::size_t stop : order) {
      std::vector<double> now(stops_[stop].size(), std::numeric_limits<double>::infinity());
      std::vector<std::size_t> from(now.size(), 0);
      for (std::size_t a = 0; a < before.size(); ++a) {
        for (std::size_t b = 0; b < now.size(); ++b) {
          const double cost = before[a] + Cost(from_first + a, first_pass_[stop] + b);
          if (cost < now[b]) {
            now[b] = cost, from[b] = a;
          }
        }
      }
      came_from.push_back(std::move(from));
      before = std::move(now);
      from_first = first_pass_[stop];
    }
    std::vector<std::size_t> chosen(order.size());
    auto pass =
        static_cast<std::size_t>(std::min_element(before.begin(), before.end()) - before.begin());
    for (std::size_t i = order.size(); i-- > 0;) {
      chosen[i] = pass;
      pass = came_from[i][pass];
    }
    PassTour tour{.path = DubinsPath(start_), .order = order, .passes = chosen, .reached = {}};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Pass& next = stops_[order[i]][chosen[i]];
      tour.path.Append(region_.ShortestInside(tour.path.end(), next.in, turn_radius_));
      tour.path.Append({.curvature = 0.0, .length = next.length});
      tour.reached.push_back(tour.path.length());
    }
    return tour;
  }

  const Pose2& start_;
  const std::vector<Stop>& stops_;
  const Region& region_;
  Meters turn_radius_;
  std::vector<std::size_t> first_pass_;
  std::vector<bool> is_either_way_;  ///< of each stop: its passes are one, as it is and reversed
  std::size_t pass_count_ = 0;
  std::vector<double> cost_;  ///< from pass (last row: the start) to pass
  std::vector<double> before_, now_;
  std::vector<std::size_t> trial_;
};

}  // namespace

PassTour PlanPassTour(const Pose2& start, const std::vector<Stop>& stops, const Region& region,
                      Meters turn_radius) {
  if (stops.empty()) {
    return {.path = DubinsPath(start), .order = {}, .passes = {}, .reached = {}};
  }
  return Salesman(start, stops, region, turn_radius).Solve();
}

}  // namespace limpet
