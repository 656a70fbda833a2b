// SPDX-License-Identifier: MIT
#include "tests/layers/citations.hpp"

#include <regex>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// What stands behind `//` on each line of `text`. Comments on neighbouring lines are joined, a
/// line without a comment ends one.
std::string CommentsOf(const std::string& text) {
  std::string comments;
  for (const std::string& line : Split(text, '\n')) {
    const std::size_t begin = line.find("//");
    if (begin == std::string::npos) {
      comments += '\n';
      continue;
    }
    const std::size_t words = line.find_first_not_of("/<! ", begin);
    if (words != std::string::npos) comments += line.substr(words) + " ";
  }
  return comments;
}

}  // namespace

std::set<std::string> ReadReferences(std::string_view markdown) {
  static const std::regex kEntry(R"(^- \*\*\[([^\]]+)\]\*\*)");
  std::set<std::string> names;
  for (const std::string& line : Split(markdown, '\n')) {
    std::smatch entry;
    if (std::regex_search(line, entry, kEntry)) names.insert(entry[1]);
  }
  return names;
}

std::vector<std::string> CitationsIn(const SourceFile& file) {
  static const std::regex kCitation(
      R"(\[((?:(?:von|van|de|der|den) )*[A-Z][^\[\]0-9,/\\\n]* [0-9]{4}[a-z]?)(?:,[^\[\]\n]*)?\])");
  std::vector<std::string> cited;
  const std::string comments = CommentsOf(file.text);
  for (std::sregex_iterator found(comments.begin(), comments.end(), kCitation), end; found != end;
       ++found) {
    cited.push_back((*found)[1]);
  }
  return cited;
}

std::vector<std::string> CitationsWithoutEntry(const std::vector<SourceFile>& files,
                                               const std::set<std::string>& references) {
  std::vector<std::string> complaints;
  for (const SourceFile& file : files) {
    for (const std::string& name : CitationsIn(file)) {
      if (!references.contains(name)) {
        complaints.push_back(fmt::format("{}: [{}] is not in docs/references.md", file.path, name));
      }
    }
  }
  return complaints;
}

}  // namespace limpet::layers
