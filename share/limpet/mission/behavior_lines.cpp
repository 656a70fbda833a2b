// SPDX-License-Identifier: MIT
#include "limpet/mission/behavior_lines.hpp"

namespace limpet {
namespace {

void SplitBraces(std::string_view text, const SourceLine& where, std::vector<TextLine>& out) {
  text = Trim(text);
  while (text.starts_with('{') || text.starts_with('}')) {
    out.push_back({std::string(text.substr(0, 1)), where});
    text = Trim(text.substr(1));
    if (text.empty()) {
      return;
    }
  }
  const bool ends_with_brace = text.ends_with('{') && !text.starts_with('#');
  if (ends_with_brace) {
    text = Trim(text.substr(0, text.size() - 1));
  }
  out.push_back({std::string(text), where});
  if (ends_with_brace) {
    out.push_back({"{", where});
  }
}

}  // namespace

std::vector<TextLine> BehaviorLines(const std::vector<TextLine>& lines) {
  std::vector<TextLine> out;
  std::string joined;
  SourceLine where;
  for (const TextLine& line : lines) {
    if (joined.empty()) {
      where = line.where;
    }
    std::string_view text = std::string_view(line.text).substr(0, line.text.find("//"));
    text = Trim(text);
    if (text.ends_with('\\')) {
      joined += std::string(Trim(text.substr(0, text.size() - 1))) + " ";
      continue;
    }
    SplitBraces(joined + std::string(text), where, out);
    joined.clear();
  }
  if (!joined.empty()) {
    SplitBraces(joined, where, out);
  }
  return out;
}

}  // namespace limpet
