// SPDX-License-Identifier: MIT
#include "tests/layers/parameter_lists.hpp"

#include <algorithm>
#include <regex>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// Who calls what a header declares need not know its file; what a file keeps to itself is called
/// where it is read.
int MostInARow(const SourceFile& file) { return file.path.ends_with(".hpp") ? 1 : 2; }

/// On one line, each blank a single one.
std::string OnOneLine(const std::string& text) {
  static const std::regex kComment("//[^\n]*"), kBlank("\\s+");
  return std::regex_replace(std::regex_replace(text, kComment, " "), kBlank, " ");
}

/// The most parameters in a row that are `double name`, defaults included.
int LongestRunOfNumbers(const std::string& parameters) {
  static const std::regex kNumber(R"( ?(?:const )?double \w+(?: = .*)? ?)");
  int run = 0, longest = 0;
  for (const std::string& parameter : Split(parameters, ',')) {
    run = std::regex_match(parameter, kNumber) ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

}  // namespace

std::vector<std::string> InterchangeableNumbers(const std::vector<SourceFile>& files) {
  static const std::regex kFunction(R"((\w+) ?\(([^(){};]*)\))");
  std::vector<std::string> complaints;
  for (const SourceFile& file : files) {
    if (file.path.starts_with("tests/")) continue;
    const std::string text = OnOneLine(file.text);
    for (std::sregex_iterator function(text.begin(), text.end(), kFunction), end; function != end;
         ++function) {
      const std::string name = (*function)[1], parameters = (*function)[2];
      if (LongestRunOfNumbers(parameters) <= MostInARow(file)) continue;
      complaints.push_back(fmt::format("{}: {}({})", file.path, name, parameters));
    }
  }
  return complaints;
}

}  // namespace limpet::layers
