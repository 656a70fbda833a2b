// SPDX-License-Identifier: MIT
// Topics of ROS as CSV, as `rostopic echo -p` writes them: a header `%time,field.a,field.b`, then a
// row per message.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/recordings/recording.hpp"

namespace limpet {

/// Adds what a file's text holds to a recording: pings of a LinkQuest DVL, or depths, told by their
/// columns. What else it is, is said in `left_out`. The error names file, line and column.
[[nodiscard]] Expected<bool> AddRosCsv(std::string_view text, const std::string& file,
                                       Recording& recording);

/// True of a file of that form, and of a folder that holds one and no stream of our own.
[[nodiscard]] bool IsRosRecording(const std::filesystem::path& named);

/// The recording in a file, or in all .csv and .csv.gz files of a folder.
[[nodiscard]] Expected<Recording> LoadRosRecording(const std::filesystem::path& named);

}  // namespace limpet
