// SPDX-License-Identifier: MIT
// The area that a mission surveys, drawn: as text for a terminal, as SVG.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "limpet/planning/region.hpp"
#include "limpet/preflight/preflight.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {

/// What is drawn of a mission, and what `check` reckons of it.
struct Site {
  std::string name;
  SurveyArea area;
  std::optional<PlanePoint> start;  ///< of its scenario.yaml
  double wanted_m2 = 0.0;           ///< ground to be seen
  double path_m = 0.0;              ///< lanes and turns
  double speed_mps = 0.0;           ///< 0: no behavior says it
};

/// Nothing if the mission surveys no area, or none that can be read. `change`, if there is one, is
/// made first. REQUIRES: it exists.
[[nodiscard]] std::optional<Site> SiteOf(const std::filesystem::path& path,
                                         const MissionChange& change = {});

/// North up, as wide as `columns`: `:` ground to be seen, `.` the rest of the operating region, `#`
/// keep-out zones, `o` way points, `S` the start; under it what the letters that occur mean, and a
/// line of figures.
[[nodiscard]] std::string SiteText(const Site& site, int columns);
[[nodiscard]] std::string SiteSvg(const Site& site);

}  // namespace limpet
