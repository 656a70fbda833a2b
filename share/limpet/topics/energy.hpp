// SPDX-License-Identifier: MIT
// What is left in the battery, and what the way home and each course take.
#pragma once

#include <optional>
#include <vector>

#include "limpet/topics/topic.hpp"

namespace limpet {

/// Energy as it is known on board: from what the gauge says, and what was used.
struct EnergyState {
  double used_wh = 0.0;  ///< since the first BATTERY was heard
  double left_wh = 0.0;
  double home_wh = 0.0;      ///< the way home, the ascent and the time at the surface there
  double reserve_wh = 0.0;   ///< to be left at home
  double reach_m = 0.0;      ///< path, the way home included, that is left to fly by these
  double capacity_wh = 0.0;  ///< of a full one
  double metre_wh = 0.0;     ///< a metre of way, as dear as it was at times
  double idle_w = 0.0;       ///< without way on
  double charge = 0.0;  ///< share of a full one; the gauge's, or less where the voltage denies that
  /// The gauge's charge above what the voltage says, share of a full one. Absent: no voltage known.
  std::optional<double> gauge_excess{};

  [[nodiscard]] double spare_wh() const { return left_wh - home_wh - reserve_wh; }
  template <class V>
  void Describe(V& visit) {
    visit("used_wh", used_wh), visit("left_wh", left_wh), visit("home_wh", home_wh);
    visit("reserve_wh", reserve_wh), visit("reach_m", reach_m);
    visit("capacity_wh", capacity_wh), visit("metre_wh", metre_wh), visit("idle_w", idle_w);
    visit("charge", charge), visit("gauge_excess", gauge_excess);
  }
};

/// What a metre over ground takes by course in the current there is: as many metres of still water
/// draw as much. At equal steps of course from north on, clockwise; empty: all courses cost alike.
struct CourseCost {
  std::vector<double> metres;

  /// Cost at `course` [rad], by the two steps beside it.
  [[nodiscard]] double At(double course) const;
};
template <>
struct TopicCodec<CourseCost> : JsonCodec<CourseCost> {};

namespace topics {
inline const auto kEnergyState = Declare<EnergyState>(
    "ENERGY_STATE", "energy used, left, and needed for the way home, learnt from what was used",
    {.unit = "Wh, m, W", .rate = "1 Hz, of a vehicle with a battery", .writers = {"pSurvey"}});
inline const auto kCourseCost =
    Declare<CourseCost>("COURSE_COST",
                        "what a metre over ground takes by course, in metres of still water that "
                        "draw as much: at equal "
                        "steps from north on; empty while no current makes a difference",
                        {.unit = "m",
                         .frame = "clockwise from north",
                         .rate = "on change, of a vehicle with a battery",
                         .writers = {"pSurvey"}});
}  // namespace topics

}  // namespace limpet
