// SPDX-License-Identifier: MIT
// Plug templates: mission text assembled from fragments, in nsplug's language.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/source_text.hpp"

namespace limpet {

struct PlugOptions {
  /// What happens to a line with an undefined macro.
  enum class Undefined {
    kKeepLine,   ///< nsplug's default: nothing in it is expanded, and a warning
    kKeepMacro,  ///< nsplug's --lenient: the defined ones are expanded
    kRefuse,     ///< nsplug's --strict: an error, unless the line is a comment
  };

  struct Macro {
    std::string name;
    std::string value;          ///< empty: defined without a value, as by `#define NAME`
    bool is_set_empty = false;  ///< `NAME=`: a value that is empty; `#ifdef NAME` does not hold
  };

  std::vector<Macro> macros;
  std::vector<std::filesystem::path> macro_files;     ///< NAME=value lines
  std::vector<std::filesystem::path> search_folders;  ///< for #include, after the input's folder
  Undefined undefined = Undefined::kKeepLine;
  std::string tag;  ///< take only this section of the input
};

struct PlugResult {
  std::vector<TextLine> lines;
  std::vector<ConfigProblem> warnings;
};

/// True if any line begins with a directive (#include, #define, #ifdef, ...), or has a macro with a
/// default, `$(SPEED:=1.4)`, which nobody but nsplug reads.
[[nodiscard]] bool HasPlugDirective(std::string_view text);

/// Expands `text` as if it were the content of `file`. Every line of the result names the file and
/// line it came from; as with nsplug each file that ends in a line feed adds an empty line. Beyond
/// nsplug, absolute include names work, and unbalanced #ifdef, #else, #endif are errors.
/// Throws ConfigError: include not found or looping, undefined macro where refused, an expansion
/// that grows beyond its bounds (lines, bytes, files read, bytes moved by macros), ...
[[nodiscard]] PlugResult ExpandPlugs(std::string_view text, const std::filesystem::path& file,
                                     const PlugOptions& options);

/// True if the problem is one of ExpandPlugs: a file to be included is nowhere.
[[nodiscard]] bool IsMissingInclude(const ConfigProblem& problem);

/// Folders called `plugs` beside or above `file`, nearest first, then those above this program.
[[nodiscard]] std::vector<std::filesystem::path> PlugFoldersAround(
    const std::filesystem::path& file);

}  // namespace limpet
