// SPDX-License-Identifier: MIT
#include "limpet/waypoints/map_params.hpp"

namespace limpet {
namespace {

bool HasBlank(std::string_view text) { return text.find_first_of(" \t") != std::string_view::npos; }

}  // namespace

void DescribeVariable(ParamCollector& visit, const char* name, std::string& field,
                      const char* help) {
  const std::string usual = field;
  visit.Parsed(name, "text", help, usual.c_str(), [&field](std::string_view text) {
    if (HasBlank(text)) return false;
    field = text;
    return true;
  });
}

void DescribeHints(ParamCollector& visit, VisualHints& hints) {
  visit.ParsedLines("visual_hints", "name=value, ...", "Colors and sizes of what it draws",
                    [&hints](std::string_view text) { return hints.Add(text); });
}

void DescribeSuffix(ParamCollector& visit, const char* name, std::string& suffix) {
  visit.Parsed(name, "text", "Added to the names of status variables, after `_`", "",
               [&suffix](std::string_view text) {
                 if (HasBlank(text)) return false;
                 suffix = text.empty() || text.front() == '_' ? std::string(text)
                                                              : "_" + std::string(text);
                 return true;
               });
}

}  // namespace limpet
