// SPDX-License-Identifier: MIT
#include "limpet/planning/lane_tours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "limpet/core/interval.hpp"
#include "limpet/planning/pass_order.hpp"

namespace limpet {
namespace {

/// A gap in a lane is flown around if it is longer than this many turn radii.
constexpr double kGapInRadii = 4.0;

struct UnseenCell {
  double north, east;
};

std::vector<UnseenCell> Unseen(const SeenPlanes& planes, std::size_t plane) {
  std::vector<UnseenCell> cells;
  planes.EachUnseen(plane, [&cells](double north, double east) { cells.push_back({north, east}); });
  return cells;
}

/// Places of cells in a lane's axes.
struct LanePlace {
  double along, across;
};

class LaneCutter {
 public:
  LaneCutter(const std::vector<UnseenCell>& cells, double yaw, const TourJudge& judge)
      : judge_(judge), yaw_(yaw), cos_(std::cos(yaw)), sin_(std::sin(yaw)) {
    for (const UnseenCell& cell : cells) {
      const LanePlace place{cell.north * cos_ + cell.east * sin_,
                            -cell.north * sin_ + cell.east * cos_};
      low_ = std::min(low_, place.across), high_ = std::max(high_, place.across);
      places_.push_back(place);
    }
    const double half_cell = 0.5 * judge.ground().frame().cell_m;
    low_ -= half_cell, high_ += half_cell;
  }

  [[nodiscard]] double width() const { return high_ - low_; }

  /// Passes along `count` lanes that share the width evenly.
  [[nodiscard]] std::vector<Pass> Passes(int count) const {
    const double spacing = width() / count;
    std::vector<std::vector<double>> alongs(static_cast<std::size_t>(count));
    for (const LanePlace& place : places_) {
      const int lane = std::clamp(static_cast<int>((place.across - low_) / spacing), 0, count - 1);
      alongs[static_cast<std::size_t>(lane)].push_back(place.along);
    }
    std::vector<Pass> passes;
    for (int lane = 0; lane < count; ++lane) {
      AddPasses(low_ + (lane + 0.5) * spacing, alongs[static_cast<std::size_t>(lane)], passes);
    }
    return passes;
  }

  /// Passes along strips of places that are not further apart than `gap` across.
  [[nodiscard]] std::vector<Pass> StripPasses(double gap) const {
    std::vector<LanePlace> places = places_;
    std::sort(places.begin(), places.end(),
              [](const LanePlace& a, const LanePlace& b) { return a.across < b.across; });
    std::vector<Pass> passes;
    for (std::size_t first = 0; first < places.size();) {
      std::size_t last = first;
      std::vector<double> alongs{places[first].along};
      while (last + 1 < places.size() && places[last + 1].across - places[last].across < gap) {
        alongs.push_back(places[++last].along);
      }
      AddPasses(0.5 * (places[first].across + places[last].across), alongs, passes);
      first = last + 1;
    }
    return passes;
  }

 private:
  void AddPasses(double across, std::vector<double>& alongs, std::vector<Pass>& passes) const {
    std::sort(alongs.begin(), alongs.end());
    const double gap = kGapInRadii * judge_.turn_radius().value();
    for (std::size_t first = 0; first < alongs.size();) {
      std::size_t last = first;
      while (last + 1 < alongs.size() && alongs[last + 1] - alongs[last] < gap)
        ++last;
      AddPass(across, {alongs[first], alongs[last]}, passes);
      first = last + 1;
    }
  }

  /// What of a lane lies inside the region, piece by piece.
  void AddPass(double across, const Interval& along, std::vector<Pass>& passes) const {
    const double inset = judge_.ground().footprint().half_along(Footprint::kTop);
    double begin = along.low + inset, end = along.high - inset;
    if (begin > end) begin = end = along.middle();
    for (double at = begin; at <= end;) {
      double piece_end = at;
      while (piece_end < end && IsOpen({piece_end, std::min(end, piece_end + kPassCut)}, across)) {
        piece_end = std::min(end, piece_end + kPassCut);
      }
      AddPiece(across, {at, piece_end}, passes);
      at = piece_end + kPassCut;
    }
  }

  /// Shorter at its ends, until there is room for the turns.
  void AddPiece(double across, Interval along, std::vector<Pass>& passes) const {
    auto& [begin, end] = along;
    while (begin + kPassCut < end && !IsFlyable({begin, across}, yaw_ + std::numbers::pi))
      begin += kPassCut;
    while (begin + kPassCut < end && !IsFlyable({end, across}, yaw_))
      end -= kPassCut;
    if (!IsFlyable({end, across}, yaw_)) return;
    passes.push_back(PassAlong(along, across));
  }

  [[nodiscard]] bool IsOpen(const Interval& along, double across) const {
    return IsInside(PassAlong(along, across), judge_.region());
  }
  [[nodiscard]] Pass PassAlong(const Interval& along, double across) const {
    return {.in = PoseAt({along.low, across}, yaw_), .length = along.high - along.low};
  }
  [[nodiscard]] Pose2 PoseAt(const LanePlace& at, double yaw) const {
    return {at.along * cos_ - at.across * sin_, at.along * sin_ + at.across * cos_, yaw};
  }
  [[nodiscard]] bool IsFlyable(const LanePlace& at, double yaw) const {
    const Pose2 pose = PoseAt(at, yaw);
    return judge_.region().Contains(pose) &&
           judge_.region().IsRecoverable(pose, judge_.turn_radius());
  }

  const TourJudge& judge_;
  double yaw_, cos_, sin_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
  std::vector<LanePlace> places_;
};

/// Makes lane tours and judges them.
class LanePlanner {
 public:
  LanePlanner(TourJudge& judge, const LaneParams& params, const SurveyTour& first)
      : judge_(judge), params_(params), first_(first) {
    static_cast<void>(judge.Cost(first));
    tops_ = Unseen(judge.planes(), SeenPlanes::kTop);
    bottoms_ = Unseen(judge.planes(), SeenPlanes::kBottom);
  }

  std::vector<SurveyTour> Plan() {
    for (int i = 0; i < params_.directions && !tops_.empty(); ++i) {
      const double yaw = std::numbers::pi * i / params_.directions;
      AddLanes(yaw);
      if (params_.with_bottom_first && !bottoms_.empty()) AddBottomFirst(yaw);
    }
    std::ranges::stable_sort(tours_, {}, &Costed::cost);
    std::vector<SurveyTour> best;
    for (Costed& costed : tours_)
      best.push_back(std::move(costed.tour));
    return best;
  }

 private:
  struct Costed {
    SurveyTour tour;
    double cost = 0.0;
  };

  [[nodiscard]] double Width(int layer) const {
    return 2.0 * judge_.ground().footprint().half_across(layer);
  }
  /// The two numbers of lanes that fit best.
  static std::array<int, 2> Counts(double width, double swath) {
    const int fewest = std::max(1, static_cast<int>(std::floor(width / swath)));
    return {fewest, fewest + 1};
  }

  [[nodiscard]] Pose2 Start() const {
    return first_.empty() ? judge_.start() : first_.back().out();
  }
  /// The lanes behind what is flown before them.
  [[nodiscard]] SurveyTour Behind(const SurveyTour& lanes) const {
    SurveyTour tour = first_;
    std::ranges::copy(lanes, std::back_inserter(tour));
    return tour;
  }
  void Add(SurveyTour tour) {
    const double cost = judge_.Cost(tour).total;
    tours_.push_back({std::move(tour), cost});
  }

  void AddLanes(double yaw) {
    const LaneCutter cutter(tops_, yaw, judge_);
    for (const int count : Counts(cutter.width(), Width(Footprint::kTop))) {
      Add(Behind(InBestOrder(judge_, Start(), cutter.Passes(count))));
    }
  }

  /// Lanes as wide as the image on the seabed, then the strips between them.
  void AddBottomFirst(double yaw) {
    const LaneCutter cutter(bottoms_, yaw, judge_);
    for (const int count : Counts(cutter.width(), Width(0))) {
      SurveyTour tour = Behind(InBestOrder(judge_, Start(), cutter.Passes(count)));
      if (tour.empty()) continue;
      static_cast<void>(judge_.Cost(tour));
      const std::vector<UnseenCell> left = Unseen(judge_.planes(), SeenPlanes::kTop);
      if (left.empty()) continue;
      const std::vector<Pass> strips = LaneCutter(left, yaw, judge_).StripPasses(0.25 * Width(0));
      std::ranges::move(InBestOrder(judge_, tour.back().out(), strips), std::back_inserter(tour));
      Add(std::move(tour));
    }
  }

  TourJudge& judge_;
  const LaneParams& params_;
  const SurveyTour& first_;
  std::vector<UnseenCell> tops_, bottoms_;
  std::vector<Costed> tours_;
};

}  // namespace

std::vector<SurveyTour> LaneTours(TourJudge& judge, const LaneParams& params,
                                  const SurveyTour& first) {
  return LanePlanner(judge, params, first).Plan();
}

}  // namespace limpet
