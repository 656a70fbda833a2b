// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/characterisation/box_model_fit.hpp"

namespace limpet {

/// What a detector file says of where it comes from.
struct SheetOrigin {
  std::string detector;   ///< its registered name
  std::string made_with;  ///< the command that makes the file again
  std::string file;       ///< the name under which a mission has it
};

/// What is wrong if the trial found too few balls, or had them in too few cells of the sheet's
/// table of range and size, for a model of the detector.
[[nodiscard]] std::optional<std::string> TooFewBalls(const TrialResult& trial);

/// The file that a mission's global DetectorFile names: which detector, what is believed of it on
/// board, what a simulated camera that makes boxes draws from; as comments, what was measured by
/// range, size, water and kind. docs/detectors.md has the format.
[[nodiscard]] std::string DetectorSheetText(const SheetOrigin& origin, const TrialResult& trial);

}  // namespace limpet
