// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/planning/survey_tour.hpp"

namespace limpet {

/// Random edits of a tour, each judged over the whole tour: passes are shifted, alone or with all
/// beside them, turned, lengthened, shortened, reversed, moved, left out, or added where something
/// is unseen or over a target, sooner rather than later; runs of them are flown the other way
/// round. Worse tours are gone on from while it is warm (simulated annealing).
class TourSearch {
 public:
  /// `warmth`: at first, tours that are about this much longer are gone on from.
  TourSearch(Meters warmth, const Random& random) : warmth_m_(warmth.value()), random_(random) {}

  /// Makes `tour` the best of those found by `edits` edits, no worse than it was; its cost.
  TourCost Improve(TourJudge& judge, SurveyTour& tour, int edits);

 private:
  [[nodiscard]] SurveyTour Edited(const TourJudge& judge, const SurveyTour& tour);
  void ShiftOne(SurveyTour& tour);
  void ShiftBeside(SurveyTour& tour);
  void StretchOne(SurveyTour& tour);
  void TurnOne(SurveyTour& tour);
  void FlipOne(SurveyTour& tour);
  void MoveOne(SurveyTour& tour);
  void ReverseRun(SurveyTour& tour);
  void DropOne(SurveyTour& tour);
  void AddOne(const TourJudge& judge, SurveyTour& tour);
  void AddLook(const TourJudge& judge, SurveyTour& tour);
  [[nodiscard]] std::size_t Any(const SurveyTour& tour) {
    return static_cast<std::size_t>(random_.Index(tour.size()));
  }

  double warmth_m_;
  Random random_;
};

}  // namespace limpet
