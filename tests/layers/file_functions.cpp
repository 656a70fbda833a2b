// SPDX-License-Identifier: MIT
#include "tests/layers/file_functions.hpp"

#include <map>
#include <regex>
#include <set>
#include <string_view>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// Each of their files is a program of its own.
bool IsOfOnePerProgram(std::string_view path) {
  return path.starts_with("tests/bench/") || path.starts_with("tests/examples/") ||
         path.starts_with("tests/fuzz/");
}

struct FunctionNames {
  std::set<std::string> hidden;  ///< in unnamed namespaces
  std::set<std::string> open;
};

/// Relies on the house's format: what stands in a namespace is not indented, and a closing brace
/// says what it closes.
FunctionNames FunctionsIn(const SourceFile& file) {
  static const std::regex kFunction(
      R"(^(?!using |return |TEST)(?:\[\[nodiscard\]\] )?[A-Za-z_][\w:<>,*& ]*[ *&](\w+)\()");
  FunctionNames names;
  bool is_unnamed = false;
  for (const std::string& line : Split(file.text, '\n')) {
    std::smatch found;
    if (line == "namespace {") {
      is_unnamed = true;
    } else if (line.starts_with("}  // namespace")) {
      is_unnamed = false;
    } else if (std::regex_search(line, found, kFunction)) {
      (is_unnamed ? names.hidden : names.open).insert(found[1]);
    }
  }
  return names;
}

}  // namespace

std::vector<std::string> FunctionsOfTwoFiles(const std::vector<SourceFile>& files) {
  struct Definers {
    int hidden = 0;
    bool in_header = false;
    std::string files;
  };
  std::map<std::string, Definers> functions;
  for (const SourceFile& file : files) {
    if (IsOfOnePerProgram(file.path)) continue;
    const std::size_t slash = file.path.rfind('/');
    const std::string folder = file.path.substr(0, slash + 1);
    const bool is_header = file.path.ends_with(".hpp");
    const FunctionNames names = FunctionsIn(file);
    for (const std::string& name : is_header ? names.open : names.hidden) {
      Definers& definers = functions[folder + name];
      definers.files += " " + file.path.substr(slash + 1);
      definers.hidden += is_header ? 0 : 1;
      definers.in_header = definers.in_header || is_header;
    }
  }
  std::vector<std::string> complaints;
  for (const auto& [name, definers] : functions) {
    const bool meet = definers.hidden > 1 || (definers.hidden == 1 && definers.in_header);
    if (meet) complaints.push_back(name + ":" + definers.files);
  }
  return complaints;
}

}  // namespace limpet::layers
