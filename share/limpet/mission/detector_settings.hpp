// SPDX-License-Identifier: MIT
// What blocks of a mission take from the file of the detector that it uses.
#pragma once

#include "limpet/mission/fact_files.hpp"

namespace limpet {

/// Name of the global of a mission that says which detector it uses, and what that one achieves.
inline constexpr const char* kDetectorFileGlobal = "DetectorFile";

/// Which keys such a file has, and for which parameters they stand: who writes one asks here, too.
[[nodiscard]] const FactFile& DetectorFacts();

}  // namespace limpet
