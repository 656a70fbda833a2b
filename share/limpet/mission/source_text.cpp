// SPDX-License-Identifier: MIT
#include "limpet/mission/source_text.hpp"

#include <fstream>
#include <iterator>

namespace limpet {

std::vector<TextLine> SplitLines(std::string_view text, const std::string& file) {
  std::vector<TextLine> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    lines.push_back({std::string(line), {file, static_cast<int>(lines.size()) + 1}});
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  return lines;
}

std::string ReadTextFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code ignored;
  if (!in || std::filesystem::is_directory(file, ignored)) {
    throw ConfigError({{file.string(), 0}, "", "cannot be read"});
  }
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace limpet
