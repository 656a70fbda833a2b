// SPDX-License-Identifier: MIT
// What a mission surveys: its area, and what `limpet check` reckons of it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "limpet/preflight/preflight.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {

/// What is drawn of a mission, and what is reckoned of it.
struct Site {
  std::string name;
  SurveyArea area;
  std::optional<PlanePoint> start_W;  ///< of its scenario.yaml
  double wanted_m2 = 0.0;             ///< ground to be seen
  double path_m = 0.0;                ///< lanes and turns
  double speed_mps = 0.0;             ///< 0: no behavior says it

  /// The site in a line: the ground to be seen, the way it takes, the time, and how many keep-out
  /// zones lie beyond what is drawn.
  [[nodiscard]] std::string Summary() const;
};

/// Nothing if the mission surveys no area, or none that can be read. `change`, if there is one, is
/// made first. REQUIRES: it exists.
[[nodiscard]] std::optional<Site> SiteOf(const std::filesystem::path& path,
                                         const MissionChange& change = {});

/// The box around the area, where the vehicle may be, the transit and the start; zones may reach
/// beyond it.
struct SiteBox {
  PlanePoint low_W, high_W;
  void Take(const PlanePoint& at);
  /// That is left around it, for marks at its edges [m].
  [[nodiscard]] double room() const;
};
[[nodiscard]] SiteBox BoxAround(const Site& site);

/// How many keep-out zones lie beyond that box and its room.
[[nodiscard]] std::ptrdiff_t ZonesBeyond(const Site& site);

}  // namespace limpet
