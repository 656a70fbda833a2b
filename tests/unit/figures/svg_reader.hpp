// SPDX-License-Identifier: MIT
// Reads the SVG that figures write, strictly: tags must close and attributes be quoted.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/number_text.hpp"

namespace limpet {

struct SvgElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text{};  ///< directly behind its tag

  [[nodiscard]] double Number(const std::string& attribute) const {
    const auto found = attributes.find(attribute);
    const auto number =
        found == attributes.end() ? std::nullopt : limpet::ParseNumber(found->second);
    EXPECT_TRUE(number) << name << " " << attribute;
    return number.value_or(std::nan(""));
  }
  [[nodiscard]] std::string Fill() const {
    const auto found = attributes.find("fill");
    return found == attributes.end() ? "" : found->second;
  }
};

inline SvgElement SvgElementOf(std::string_view tag) {
  SvgElement element;
  const std::size_t blank = std::min(tag.find(' '), tag.size());
  element.name = tag.substr(0, blank);
  for (std::size_t at = blank; (at = tag.find_first_not_of(' ', at)) != std::string_view::npos;) {
    const std::size_t equals = tag.find("=\"", at);
    const std::size_t close = equals == std::string_view::npos ? equals : tag.find('"', equals + 2);
    if (close == std::string_view::npos) {
      ADD_FAILURE() << "an attribute without quotes: " << tag;
      break;
    }
    const bool is_new =
        element.attributes
            .emplace(tag.substr(at, equals - at), tag.substr(equals + 2, close - equals - 2))
            .second;
    EXPECT_TRUE(is_new) << "an attribute twice: " << tag;
    at = close + 1;
  }
  return element;
}

/// Every element in order; a failure of the test for text that is no XML.
inline std::vector<SvgElement> ReadSvg(std::string_view svg) {
  std::vector<SvgElement> elements;
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = svg.find('<', at)) != std::string_view::npos;) {
    const std::size_t end = svg.find('>', at);
    if (end == std::string_view::npos) {
      ADD_FAILURE() << "a tag that does not end";
      break;
    }
    std::string_view tag = svg.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag.starts_with('/')) {
      EXPECT_FALSE(open.empty() || open.back() != tag.substr(1)) << tag;
      if (!open.empty()) open.pop_back();
      continue;
    }
    const bool is_closed = tag.ends_with('/');
    tag.remove_suffix(is_closed ? 1 : 0);
    elements.push_back(SvgElementOf(tag));
    elements.back().text = svg.substr(at, std::min(svg.find('<', at), svg.size()) - at);
    if (!is_closed) open.push_back(elements.back().name);
  }
  EXPECT_TRUE(open.empty()) << "tags left open";
  return elements;
}

}  // namespace limpet
