// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kFormerMap = DeclareWarning(
    "FORMER_MAP",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap", "pSession"},
     .meaning = "A part of the former session's octree cannot be read, or has voxels of another "
                "size: there the map of this session knows of the ground only what its own beams "
                "show.",
     .action =
         "Look at it with `limpet map info`; compare the versions of Limpet of both sessions.",
     .clears = "It stands to the end of the run."});

}  // namespace limpet::warnings
