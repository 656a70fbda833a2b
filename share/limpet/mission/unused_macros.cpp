// SPDX-License-Identifier: MIT
#include "limpet/mission/unused_macros.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limpet/mission/plug.hpp"
#include "limpet/mission/plug_macros.hpp"
#include "limpet/mission/source_text.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kConditions{"#ifdef", "#ifndef", "#elseifdef"};
constexpr std::size_t kMostFiles = 200;

std::string_view FirstWordOf(std::string_view text) {
  text = Trim(text);
  return text.substr(0, text.find_first_of(" \t"));
}

/// `ZONE_10` as `ZONE_`; empty if the name has no number.
std::string_view SeriesOf(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const bool is_numbered =
      last != std::string_view::npos && last + 1 < name.size() && name[last] == '_';
  return is_numbered ? name.substr(0, last + 1) : std::string_view();
}

/// What a file and all that it includes define and use.
class MacroNames {
 public:
  explicit MacroNames(const fs::path& file)
      : folder_(file.parent_path()), plug_folders_(PlugFoldersAround(file)) {
    Read(file);
  }

  [[nodiscard]] std::vector<UnusedMacro> Unused() const {
    const std::vector<std::string> used(used_.begin(), used_.end());
    std::vector<UnusedMacro> unused;
    for (const Definition& definition : defined_) {
      if (used_.contains(definition.name)) continue;
      const std::vector<std::string> series = UsedOfSeries(SeriesOf(definition.name));
      const std::string nearest = NearestWord(definition.name, used);
      const std::string instead =
          series.empty() ? (nearest.empty() ? "" : "; nearest that is: `" + nearest + "`")
                         : "; of its series these are: " + fmt::to_string(fmt::join(series, ", "));
      unused.push_back({.problem = {definition.where, "#define",
                                    fmt::format("nothing in the mission's files uses the macro "
                                                "`{}`{}",
                                                definition.name, instead)},
                        .is_beyond_its_series = !series.empty()});
    }
    return unused;
  }

 private:
  struct Definition {
    std::string name;
    SourceLine where;
  };

  /// Those with a number, and what the series is also known by: without one, as a file of more.
  [[nodiscard]] std::vector<std::string> UsedOfSeries(std::string_view series) const {
    std::vector<std::string> members;
    if (series.empty()) return members;
    std::ranges::copy_if(used_, std::back_inserter(members),
                         [series](const std::string& name) { return SeriesOf(name) == series; });
    if (members.empty()) return members;
    const std::string name(series.substr(0, series.size() - 1));
    for (const std::string& other : {name, name + "_FILE"}) {
      if (used_.contains(other)) members.push_back(other);
    }
    return members;
  }

  void Read(const fs::path& file) {
    std::error_code ignored;
    const bool is_new = read_.size() < kMostFiles && read_.insert(file.lexically_normal()).second;
    if (!is_new || !fs::is_regular_file(file, ignored)) return;
    for (const TextLine& line : SplitLines(ReadTextFile(file), file.string()))
      Take(line);
  }

  void Take(const TextLine& line) {
    const std::string_view text = Trim(line.text);
    const std::string_view first = FirstWordOf(text);
    const std::string_view rest = Trim(text.substr(first.size()));
    if (first == "#define") {
      Define(rest, line.where);
    } else if (first == "#include") {
      UseIn(rest);
      Include(rest);
    } else if (std::ranges::find(kConditions, first) != kConditions.end()) {
      for (const std::string& word : Split(rest, ' '))
        used_.insert(std::string(Trim(word)));
    } else {
      UseIn(text);
    }
  }

  void Define(std::string_view rest, const SourceLine& where) {
    std::string_view name = FirstWordOf(rest);
    const std::string_view value = Trim(rest.substr(name.size()));
    if (name.starts_with("$(") && name.ends_with(')')) name = name.substr(2, name.size() - 3);
    defined_.push_back({std::string(name), where});
    values_.Define(name, {.value = std::string(value)});
    UseIn(value);
  }

  /// Each `$(NAME` and `%(NAME`.
  void UseIn(std::string_view text) {
    for (std::size_t at = text.find('('); at != std::string_view::npos;
         at = text.find('(', at + 1)) {
      if (at == 0 || (text[at - 1] != '$' && text[at - 1] != '%')) continue;
      const std::string_view behind = text.substr(at + 1);
      used_.insert(std::string(behind.substr(0, behind.find_first_of(")=:($%"))));
    }
  }

  /// A section of a file may be named behind it.
  void Include(std::string_view rest) {
    const std::string expanded = values_.Expand(rest).text;
    std::string_view name = Trim(std::string_view(expanded).substr(0, expanded.rfind('<')));
    if (name.size() >= 2 && name.starts_with('"') && name.ends_with('"')) {
      name = name.substr(1, name.size() - 2);
    }
    std::vector<fs::path> folders{folder_};
    folders.insert(folders.end(), plug_folders_.begin(), plug_folders_.end());
    for (const fs::path& folder : folders) {
      std::error_code ignored;
      if (name.empty() || !fs::is_regular_file(folder / name, ignored)) continue;
      Read(folder / name);
      return;
    }
  }

  fs::path folder_;
  std::vector<fs::path> plug_folders_;
  std::set<fs::path> read_;
  PlugMacros values_;
  std::vector<Definition> defined_;
  std::set<std::string, std::less<>> used_;
};

}  // namespace

std::vector<UnusedMacro> UnusedMacros(const fs::path& file) {
  try {
    return MacroNames(file).Unused();
  } catch (const ConfigError&) {
    return {};  // whoever reads the mission says so
  }
}

}  // namespace limpet
