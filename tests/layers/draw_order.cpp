// SPDX-License-Identifier: MIT
#include "tests/layers/draw_order.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <regex>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace limpet::layers {
namespace {

/// Comments, and what is quoted, as blanks; as long as before.
std::string WithoutWords(std::string text) {
  static const std::regex kWords(R"re(//[^\n]*|"(?:\\.|[^"\\\n])*")re");
  const std::string read = text;
  for (std::sregex_iterator words(read.begin(), read.end(), kWords), end; words != end; ++words) {
    const auto from = text.begin() + words->position();
    std::fill(from, from + words->length(), ' ');
  }
  return text;
}

/// Where something is drawn.
std::set<std::size_t> DrawsIn(const std::string& text) {
  static const std::regex kDraw(R"re((?:\.|->)(?:Normal|Uniform|Chance|Bits)\()re"
                                R"re(|[Rr]andom\w*(?:\.|->)Index\()re"
                                R"re(|\w\([^()]*\brandom_?\b(?![.\w]|->)[^()]*\))re");
  std::set<std::size_t> draws;
  for (std::sregex_iterator draw(text.begin(), text.end(), kDraw), end; draw != end; ++draw) {
    // A declaration takes a Random, and draws nothing.
    if (draw->str().find("Random& ") != std::string::npos) continue;
    draws.insert(static_cast<std::size_t>(draw->position()));
  }
  return draws;
}

/// A bracket that has been opened, and what stands in it so far.
struct Bracket {
  std::size_t at = 0;
  bool draws = false;  ///< the argument that is being read
  int drawing = 0;     ///< arguments before it that draw
};

bool IsOfACall(std::string_view text, std::size_t parenthesis) {
  return parenthesis > 0 && (std::isalnum(static_cast<unsigned char>(text[parenthesis - 1])) != 0 ||
                             text[parenthesis - 1] == '_' || text[parenthesis - 1] == '>');
}

/// Where the parentheses of calls open in which more than one argument draws.
std::vector<std::size_t> DrawTwice(const std::string& text) {
  const std::set<std::size_t> draws = DrawsIn(text);
  std::vector<std::size_t> found;
  std::vector<Bracket> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (draws.contains(i)) {
      for (Bracket& bracket : open)
        bracket.draws = true;
    }
    if (c == '(' || c == '[' || c == '{') {
      open.push_back({.at = i});
    } else if (open.empty()) {
      continue;
    } else if (c == ',') {
      open.back().drawing += open.back().draws ? 1 : 0;
      open.back().draws = false;
    } else if (c == ';') {
      open.back().draws = false, open.back().drawing = 0;
    } else if (c == ')' || c == ']' || c == '}') {
      const Bracket shut = open.back();
      open.pop_back();
      const bool draws_twice = shut.drawing + (shut.draws ? 1 : 0) > 1;
      if (c == ')' && draws_twice && IsOfACall(text, shut.at)) found.push_back(shut.at);
    }
  }
  return found;
}

}  // namespace

std::vector<std::string> CallsThatDrawTwice(const std::vector<SourceFile>& files) {
  std::vector<std::string> complaints;
  for (const SourceFile& file : files) {
    if (file.path.starts_with("tests/unit/")) continue;
    const std::string text = WithoutWords(file.text);
    for (const std::size_t at : DrawTwice(text)) {
      const std::size_t line_start = text.rfind('\n', at) + 1, line_end = text.find('\n', at);
      const auto from = text.begin();
      complaints.push_back(
          fmt::format("{}:{}: {}", file.path,
                      1 + std::count(from, from + static_cast<std::ptrdiff_t>(line_start), '\n'),
                      file.text.substr(line_start, line_end - line_start)));
    }
  }
  return complaints;
}

}  // namespace limpet::layers
