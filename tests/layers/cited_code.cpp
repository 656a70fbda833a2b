// SPDX-License-Identifier: MIT
#include "tests/layers/cited_code.hpp"

#include <algorithm>
#include <regex>

#include <fmt/format.h>

namespace limpet::layers {

std::vector<std::string> WronglyCited(std::string_view page, const std::vector<SourceFile>& files) {
  static const std::regex kBlock("<!-- ([^ ]+) -->\n```cpp\n([^`]*)```");
  std::vector<std::string> complaints;
  const std::string text(page);
  for (std::sregex_iterator block(text.begin(), text.end(), kBlock), end; block != end; ++block) {
    const std::string path = (*block)[1], code = (*block)[2];
    const auto file = std::ranges::find(files, path, &SourceFile::path);
    if (file == files.end()) {
      complaints.push_back(fmt::format("{}: there is no such file", path));
    } else if (("\n" + file->text).find("\n" + code) == std::string::npos) {
      complaints.push_back(fmt::format("{}: does not hold:\n{}", path, code));
    }
  }
  return complaints;
}

}  // namespace limpet::layers
