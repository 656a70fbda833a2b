// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "limpet/core/expected.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/recordings/recording.hpp"

namespace limpet {

/// What a vehicle's own navigation wrote into a log of MOOS: NAV_X, NAV_Y, NAV_HEADING, NAV_SPEED,
/// NAV_DEPTH, NAV_ALTITUDE. `file` is what messages call it. The error says what of it is no log.
[[nodiscard]] Expected<Recording> ReadMoosLog(AlogReader& reader, const std::string& file);

/// True of a file called .alog or .alog.gz, and of a folder that holds one and no other recording.
[[nodiscard]] bool IsMoosRecording(const std::filesystem::path& named);

/// The recording in a log, or in a folder with one log of a vehicle in it.
[[nodiscard]] Expected<Recording> LoadMoosRecording(const std::filesystem::path& named);

}  // namespace limpet
