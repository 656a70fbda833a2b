// SPDX-License-Identifier: MIT
#include "limpet/sweeps/refused_run.hpp"

#include <vector>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/core/config.hpp"
#include "limpet/durable/durable_file.hpp"

namespace limpet {

std::string RefusedRunText(std::uint64_t seed, const std::filesystem::path& log) {
  const Expected<std::string> text = ReadWhole(log);
  std::vector<std::string> lines = Split(text ? *text : "", '\n');
  std::erase_if(lines, [](const std::string& line) { return Trim(line).empty(); });
  const std::string file = OneLine(log.string());
  if (lines.empty()) return fmt::format("seed {} was refused: see {}", seed, file);
  const std::string reason = OneLine(lines.front());
  if (lines.size() == 1) return fmt::format("seed {} was refused: {}", seed, reason);
  return fmt::format("seed {} was refused: {} ({} more line{} in {})", seed, reason,
                     lines.size() - 1, lines.size() == 2 ? "" : "s", file);
}

}  // namespace limpet
