// SPDX-License-Identifier: MIT
// A fix at the surface in the middle of a survey.
#pragma once

#include "limpet/topics/topic.hpp"
#include "limpet/topics/variable.hpp"

namespace limpet::topics {

inline const auto kSurfaceFix =
    Declare<bool>("SURFACE_FIX", "the survey is left for a fix at the surface (BHV_SurfaceFix)",
                  {.rate = "on event", .writers = {"pHelm"}});

}  // namespace limpet::topics
