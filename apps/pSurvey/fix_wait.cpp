// SPDX-License-Identifier: MIT
#include "apps/pSurvey/fix_wait.hpp"

#include <algorithm>

namespace limpet {

FixWait FixWait::BeforeDive(const SurveyParams& params, bool has_former) {
  return {.target = has_former ? std::max(params.fix_target, params.former_fix_target)
                               : params.fix_target,
          .shortest = params.fix_wait_min,
          .longest = params.align};
}

FixWait FixWait::AtTheEnd(const SurveyParams& params) {
  return {.target = params.last_fix_target,
          .shortest = params.fix_wait_min,
          .longest = params.last_fix};
}

bool FixWait::IsOver(Seconds waited, const NavState& nav) const {
  if (waited >= longest) return true;
  const bool has_sigmas = nav.sd_north > 0.0 && nav.sd_east > 0.0;
  return waited >= shortest && nav.gps.is_valid.value_or(false) && has_sigmas &&
         std::max(nav.sd_north, nav.sd_east) <= target.value();
}

}  // namespace limpet
