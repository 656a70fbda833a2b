// SPDX-License-Identifier: MIT
#include "tests/layers/type_names.hpp"

#include <map>
#include <regex>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// The types that a file defines in named namespaces. Relies on the house's format: what stands in
/// a namespace is not indented, and a closing brace says what it closes.
std::vector<std::string> TypesDefinedIn(const SourceFile& file) {
  static const std::regex kType(R"(^(?:struct|class|enum class) (\w+)(?: final)?(?: :[^;]*)? ?\{)");
  static const std::regex kOpening(R"(^namespace ([\w:]+) \{)");
  std::vector<std::string> types, spaces;
  bool is_unnamed = false;
  for (const std::string& line : Split(file.text, '\n')) {
    std::smatch found;
    if (line == "namespace {") {
      is_unnamed = true;
    } else if (line == "}  // namespace") {
      is_unnamed = false;
    } else if (std::regex_search(line, found, kOpening)) {
      spaces.push_back(found[1].str() + "::");
    } else if (line.starts_with("}  // namespace ") && !spaces.empty()) {
      spaces.pop_back();
    } else if (!is_unnamed && std::regex_search(line, found, kType)) {
      std::string name;
      for (const std::string& space : spaces)
        name += space;
      types.push_back(name + found[1].str());
    }
  }
  return types;
}

}  // namespace

std::vector<std::string> TypesDefinedTwice(const std::vector<SourceFile>& files) {
  std::map<std::string, std::vector<std::string>> definers;
  for (const SourceFile& file : files) {
    for (const std::string& type : TypesDefinedIn(file)) {
      definers[type].push_back(file.path);
    }
  }
  std::vector<std::string> complaints;
  for (const auto& [type, paths] : definers) {
    if (paths.size() < 2) continue;
    std::string complaint = type + ":";
    for (const std::string& path : paths)
      complaint += " " + path;
    complaints.push_back(complaint);
  }
  return complaints;
}

}  // namespace limpet::layers
