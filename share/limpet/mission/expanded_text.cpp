// SPDX-License-Identifier: MIT
#include "limpet/mission/expanded_text.hpp"

#include <vector>

#include "limpet/mission/mission_file.hpp"

namespace limpet {

std::string ExpandedText(std::string_view text, const std::filesystem::path& file) {
  if (!HasPlugDirective(text)) return std::string(text);
  std::vector<ConfigProblem> ignored;
  std::string expanded;
  for (const TextLine& line : ConfigLines(text, file, MissionPlugOptions(file), ignored)) {
    expanded += line.text + "\n";
  }
  return expanded;
}

}  // namespace limpet
