// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/interval.hpp"
#include "limpet/planning/survey_tour.hpp"

namespace limpet {

/// A tour as it is flown.
struct FlownTour {
  DubinsPath path;              ///< what leads to the first pass included
  SurveyTour passes;            ///< those that can be reached without leaving the region
  std::vector<Interval> spans;  ///< of path length on which each is flown [m]
  bool is_complete = true;      ///< no pass was left out
};

/// Flies `way` and then the tour: the shortest words between passes where one stays inside the
/// region, else a way through the region by legs.
[[nodiscard]] FlownTour Fly(const DubinsPath& way, const SurveyTour& tour, const Region& region,
                            Meters turn_radius);

/// As Fly, and what `way` does is kept as passes of its own: its straight pieces, and where it
/// turns from one side to the other, or ends in a turn, the pose there. What is left of the tour
/// later still shows what the rest of `way` does.
[[nodiscard]] FlownTour FlyAsPasses(const DubinsPath& way, const SurveyTour& tour,
                                    const Region& region, Meters turn_radius);

/// Its passes cut shorter at their ends, until there is room to turn within the region; those of
/// which nothing is left are left out.
[[nodiscard]] SurveyTour FittedInside(const SurveyTour& tour, const Region& region,
                                      Meters turn_radius);

/// What is left of a tour once `flown` metres of its path are.
[[nodiscard]] SurveyTour RestAfter(const FlownTour& tour, double flown);

}  // namespace limpet
