// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/survey/survey_params.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// How long to wait at the surface for fixes: until navigation is as sure of its place as that, at
/// most so long. Navigation counts fixes whose error wanders for what they are worth, so that a
/// minute of them may tell little more than the first one.
struct FixWait {
  Meters target;  ///< 1-sigma of the horizontal axis that is known worse
  Seconds shortest, longest;

  /// Before the dive. `has_former`: a former session's objects, seen again, will tie this session
  /// to that one's fixes.
  [[nodiscard]] static FixWait BeforeDive(const SurveyParams& params, bool has_former);
  [[nodiscard]] static FixWait AtTheEnd(const SurveyParams& params);

  /// `waited`: since the wait began; `nav`: the latest. Who states no sigma, or hears no fixes, has
  /// waited enough only when nothing more is waited for.
  [[nodiscard]] bool IsOver(Seconds waited, const NavState& nav) const;
};

}  // namespace limpet
