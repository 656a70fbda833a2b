// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/recordings/recording.hpp"
#include "limpet/recordings/recording_check.hpp"

namespace limpet {

/// The check as text for a person.
[[nodiscard]] std::string CheckText(const Recording& recording, const RecordingCheck& check);
/// The check as JSON for a program.
[[nodiscard]] std::string CheckJson(const Recording& recording, const RecordingCheck& check);
/// What lacks, a line each, and what that costs.
[[nodiscard]] std::string MissingText(const Recording& recording);

}  // namespace limpet
