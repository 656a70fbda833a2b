// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace limpet {

/// `seed 7 was refused: <first line that it printed> (2 more lines in out/7.txt)`.
[[nodiscard]] std::string RefusedRunText(std::uint64_t seed, const std::filesystem::path& log);

}  // namespace limpet
