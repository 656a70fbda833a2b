// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace limpet {

/// What can be said of a file that is two columns of numbers, as scripts cut them out of logs: how
/// many places and how long their path is, should they be NAV_X and NAV_Y, and what is missing.
/// Empty if it is something else.
[[nodiscard]] std::string PlaceColumnsText(const std::filesystem::path& file);

}  // namespace limpet
