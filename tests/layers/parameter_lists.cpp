// SPDX-License-Identifier: MIT
#include "tests/layers/parameter_lists.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <string_view>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// Whose order everybody knows: axes; from, to and a share; distances that grow.
constexpr std::array<std::string_view, 3> kKnownByHeart{"RotationFromRollPitchYaw", "Mix", "Worth"};
constexpr int kMostInARow = 2;

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
      if (LongestRunOfNumbers(parameters) <= kMostInARow) continue;
      if (std::ranges::find(kKnownByHeart, name) != kKnownByHeart.end()) continue;
      complaints.push_back(fmt::format("{}: {}({})", file.path, name, parameters));
    }
  }
  return complaints;
}

}  // namespace limpet::layers
