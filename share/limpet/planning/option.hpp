// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/planning/dubins_path.hpp"

namespace limpet {

/// Something the vehicle could do next: a generator offers it, behaviors value it.
struct Option {
  std::string source;  ///< name of the generator (or behavior) that offers it, e.g. beam
  DubinsPath path;     ///< what would be flown; NED
  /// What the generator itself thinks of it [m of path]: orders its offers, decides nothing.
  double estimate = 0.0;
  /// For generators that plan single views instead of motions: where the images that count would be
  /// taken, NED. The first is the end of `path`; the others are of what would follow. Empty: the
  /// whole motion counts.
  std::vector<Pose2> views{};
  /// Set where the option was completed to all that is left of the survey: so much of its path it
  /// stands for itself [m]; what follows is the plan's.
  std::optional<double> own_m{};
  /// Of one that was completed: what it would take about to see what its end lacks of the finish
  /// [m of path]; 0 if the survey is over then.
  double lacking_m = 0.0;
  /// Of one that was completed: path until most of bottom and band has been seen (TourCost::most).
  double most_m = 0.0;

  /// Whether its path ends where the survey does.
  [[nodiscard]] bool is_whole() const { return own_m.has_value(); }
  /// How much of its path is flown for its own sake [m].
  [[nodiscard]] double own_length() const { return own_m.value_or(path.length()); }
};

}  // namespace limpet
