// SPDX-License-Identifier: MIT
#include "limpet/mission/plug.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "limpet/core/folders_above.hpp"
#include "limpet/mission/plug_condition.hpp"
#include "limpet/mission/plug_macros.hpp"

namespace limpet {
namespace {

constexpr std::string_view kInclude = "#include", kNotFound = " is not found";

namespace fs = std::filesystem;

// A template of 800 bytes may ask for anything: fragments include each other's copies, values
// double. Stock templates stay three orders of magnitude below each of these.
constexpr std::size_t kMaxLines = 100'000;
constexpr std::size_t kMaxBytes = std::size_t{4} << 20U;
constexpr std::size_t kMaxBytesRead = std::size_t{8} << 20U;
constexpr int kMaxFilesRead = 1000;
constexpr std::size_t kMaxDepth = 64;
constexpr std::string_view kTagMarker = "<tag>";

/// First word and the rest of a line, both trimmed.
struct Words {
  std::string_view first;
  std::string_view rest;
};
Words FirstWord(std::string_view line) {
  line = Trim(line);
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  return {line.substr(0, end), Trim(line.substr(end))};
}

/// Blanks and tabs in a row become one blank.
std::string Compact(std::string_view text) {
  std::string compact;
  for (const char letter : text) {
    const bool is_blank = letter == ' ' || letter == '\t';
    if (!is_blank || !compact.ends_with(' ')) {
      compact += is_blank ? ' ' : letter;
    }
  }
  return compact;
}

std::string_view WithoutQuotes(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && text.starts_with('"') && text.ends_with('"');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// `<name>` and `name` mean the same tag.
std::string_view TagName(std::string_view text) {
  text = Trim(text);
  return text.starts_with('<') && text.ends_with('>') ? Trim(text.substr(1, text.size() - 2))
                                                      : text;
}

/// The section that begins at this line: `<tag><name>`, `<tag> <name>` or `<tag> name`.
std::optional<std::string_view> SectionAt(std::string_view line) {
  line = Trim(line);
  return line.starts_with(kTagMarker) ? std::optional(TagName(line.substr(kTagMarker.size())))
                                      : std::nullopt;
}

class Expander {
 public:
  explicit Expander(const PlugOptions& options) : options_(options) {}

  PlugResult Run(std::string_view text, const fs::path& file) {
    for (const fs::path& macro_file : options_.macro_files) {
      ReadMacroFile(macro_file);
    }
    for (const PlugOptions::Macro& macro : options_.macros) {
      macros_.Define(macro.name, {.value = macro.value, .is_set_empty = macro.is_set_empty});
    }
    ExpandFile(text, file, options_.tag);
    return std::move(result_);
  }

 private:
  [[noreturn]] static void Fail(const SourceLine& where, std::string_view key, std::string text) {
    throw ConfigError({where, std::string(key), std::move(text)});
  }
  void WarnOf(const SourceLine& where, std::string_view key, std::string text) {
    result_.warnings.push_back({where, std::string(key), std::move(text)});
  }

  void ExpandFile(std::string_view text, const fs::path& file, std::string_view tag) {
    open_files_.push_back(file.lexically_normal());
    if (open_files_.size() > kMaxDepth) {
      Fail({file.string(), 0}, "#include", "nested too deeply");
    }
    std::vector<TextLine> lines = SplitLines(text, file.string());
    const SourceLine end{file.string(), static_cast<int>(lines.size()) + 1};
    if (text.empty() || text.ends_with('\n')) {
      lines.push_back({"", end});  // nsplug takes what follows the last line feed for a line
    }
    if (tag.empty()) {
      ExpandLines(lines, end);
    } else {
      ExpandSection(lines, tag, end);
    }
    open_files_.pop_back();
  }

  void ExpandLines(const std::vector<TextLine>& lines, const SourceLine& end) {
    PlugConditions conditions(macros_, options_.undefined == PlugOptions::Undefined::kRefuse);
    for (const TextLine& line : lines) {
      const Words words = FirstWord(line.text);
      if (conditions.Takes(words.first, words.rest, line.where) || !conditions.is_active()) {
        std::ranges::move(conditions.TakeWarnings(), std::back_inserter(result_.warnings));
        continue;
      }
      if (words.first == "#include") {
        Include(words.rest, line.where);
      } else if (words.first == "#define") {
        Define(words.rest, line.where);
      } else if (!SectionAt(line.text)) {
        Emit(line);
      }
    }
    conditions.RequireClosed(end);
  }

  /// The lines from each marker of `tag` to the next marker; directives in them are skipped.
  void ExpandSection(const std::vector<TextLine>& lines, std::string_view tag,
                     const SourceLine& end) {
    bool is_inside = false;
    bool is_found = false;
    for (const TextLine& line : lines) {
      if (const auto section = SectionAt(line.text)) {
        is_inside = *section == TagName(tag);
        is_found = is_found || is_inside;
      } else if (is_inside && !Trim(line.text).starts_with('#')) {
        Emit(line);
      }
    }
    if (!is_found) {
      WarnOf({end.file, 0}, "<tag>", fmt::format("no section `{}`", TagName(tag)));
    }
  }

  void Put(std::string text, const SourceLine& where) {
    bytes_ += text.size();
    if (result_.lines.size() >= kMaxLines || bytes_ > kMaxBytes) {
      Fail(where, "",
           fmt::format("the expansion is too big: more than {} lines or {} MiB", kMaxLines,
                       kMaxBytes >> 20U));
    }
    result_.lines.push_back({std::move(text), where});
  }

  /// All macros of a text, within bounds.
  PlugMacros::Expansion Expanded(std::string_view text, const SourceLine& where) {
    PlugMacros::Expansion expansion = macros_.Expand(text);
    if (expansion.is_too_long) {
      Fail(where, "",
           fmt::format("its macros grow beyond {} KiB in a line or {} MiB in a template; does one "
                       "hold itself?",
                       PlugMacros::kMaxLineBytes >> 10U, PlugMacros::kMaxWorkBytes >> 20U));
    }
    return expansion;
  }

  void Emit(const TextLine& line) {
    PlugMacros::Expansion expansion = Expanded(line.text, line.where);
    if (expansion.left.empty() && !expansion.is_endless) {
      Put(std::move(expansion.text), line.where);
      return;
    }
    const std::string complaint = expansion.is_endless
                                      ? "after 100 rounds a macro still stands for macros; does "
                                        "one hold itself?"
                                      : UndefinedText(expansion.unknown);
    const bool is_comment = Trim(line.text).starts_with("//");
    if (options_.undefined == PlugOptions::Undefined::kRefuse && !is_comment) {
      Fail(line.where, expansion.left, complaint);
    }
    if (!is_comment) {
      WarnOf(line.where, expansion.left, complaint);
    }
    const bool keeps_line =
        options_.undefined == PlugOptions::Undefined::kKeepLine || expansion.is_endless;
    Put(keeps_line ? line.text : expansion.text, line.where);
  }

  /// Looks for a near name for the first hundred only: that takes the product of all lengths.
  [[nodiscard]] std::string UndefinedText(const std::string& macro) {
    constexpr int kMostSuggestions = 100;
    if (macro.empty()) {
      return "is no macro";
    }
    const std::string nearest =
        ++undefined_ <= kMostSuggestions ? NearestWord(macro, macros_.Names()) : "";
    return fmt::format("undefined macro{}",
                       nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
  }

  void Define(std::string_view rest, const SourceLine& where) {
    const Words words = FirstWord(rest);
    std::string_view name = words.first;
    if (name.starts_with("$(") && name.ends_with(')')) {
      name = name.substr(2, name.size() - 3);
    }
    if (name.empty()) {
      Fail(where, "#define", "needs a name");
    }
    if (macros_.Define(name, {.value = Compact(words.rest)})) {
      WarnOf(where, "#define", fmt::format("`{}` had another value; the last one wins", name));
    }
  }

  void Include(std::string_view rest, const SourceLine& where) {
    const PlugMacros::Expansion expansion = Expanded(rest, where);
    std::string_view name = Trim(expansion.text);
    std::string_view tag;
    const std::size_t blank = name.find_last_of(" \t");
    const std::size_t last = blank == std::string_view::npos ? 0 : blank + 1;
    if (last > 0 && name.substr(last).starts_with('<') && name.ends_with('>')) {
      tag = name.substr(last);
      name = Trim(name.substr(0, last));
    }
    name = WithoutQuotes(name);
    const std::optional<fs::path> file = FindInclude(name);
    if (!file) {
      Fail(where, kInclude, fmt::format("`{}`{}{}", name, kNotFound, SearchedText()));
    }
    // A section includes nothing: so a file may take one of its own.
    if (tag.empty() &&
        std::ranges::find(open_files_, file->lexically_normal()) != open_files_.end()) {
      Fail(where, "#include", fmt::format("`{}` includes itself", name));
    }
    const std::string text = ReadTextFile(*file);
    bytes_read_ += text.size();
    if (++files_read_ > kMaxFilesRead || bytes_read_ > kMaxBytesRead) {
      Fail(where, "#include",
           fmt::format("more than {} inclusions or {} MiB of them", kMaxFilesRead,
                       kMaxBytesRead >> 20U));
    }
    ExpandFile(text, *file, tag);
  }

  [[nodiscard]] std::optional<fs::path> FindInclude(std::string_view name) const {
    std::vector<fs::path> folders{open_files_.front().parent_path()};
    folders.insert(folders.end(), options_.search_folders.begin(), options_.search_folders.end());
    for (const fs::path& folder : folders) {
      std::error_code ignored;
      if (!name.empty() && fs::is_regular_file(folder / name, ignored)) {
        return folder / name;  // an absolute name replaces the folder
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string SearchedText() const {
    std::string text = " beside this file";
    if (options_.search_folders.empty()) {
      text += ", and no folder called `plugs` is beside or above it or the program";
    }
    for (const fs::path& folder : options_.search_folders) {
      text += ", nor in " + folder.string();
    }
    return text;
  }

  /// Later lines may use earlier ones; a conflicting redefinition is ignored.
  void ReadMacroFile(const fs::path& file) {
    for (const TextLine& line : SplitLines(ReadTextFile(file), file.string())) {
      const std::string_view text = Trim(line.text);
      if (text.empty() || text.starts_with('#') || text.starts_with("//")) {
        continue;
      }
      const std::size_t equals = text.find('=');
      const std::string_view name = Trim(text.substr(0, equals));
      if (equals == std::string_view::npos || name.empty()) {
        Fail(line.where, "", fmt::format("`{}` is not NAME=value", text));
      }
      const std::string value =
          Expanded(WithoutQuotes(Trim(text.substr(equals + 1))), line.where).text;
      const PlugMacros::Macro* old = macros_.Find(name);
      if (old != nullptr && old->value != value) {
        WarnOf(line.where, name, "has another value already; this one is ignored");
      } else {
        macros_.Define(name, {.value = value});
      }
    }
  }

  const PlugOptions& options_;
  PlugMacros macros_;
  std::vector<fs::path> open_files_;  ///< from the input to the fragment being read
  PlugResult result_;
  std::size_t bytes_ = 0, bytes_read_ = 0;
  int files_read_ = 0, undefined_ = 0;
};

/// `$(SPEED:=1.4)`, `$(SPEED=1.4)`, or one of these with `%`.
bool HasDefaultedMacro(std::string_view line) {
  const auto next = [line](std::size_t from) {
    return std::min(line.find("$(", from), line.find("%(", from));
  };
  for (std::size_t at = next(0); at != std::string_view::npos; at = next(at + 1)) {
    const std::size_t end = line.find_first_of(")=", at);
    if (end != std::string_view::npos && line[end] == '=') return true;
  }
  return false;
}

}  // namespace

bool HasPlugDirective(std::string_view text) {
  constexpr std::array<std::string_view, 7> kDirectives{
      "#include", "#define", "#ifdef", "#ifndef", "#elseifdef", "#else", "#endif"};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const bool is_directive =
        std::ranges::find(kDirectives, FirstWord(line).first) != kDirectives.end();
    if (is_directive || SectionAt(line) || HasDefaultedMacro(line)) {
      return true;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

bool IsMissingInclude(const ConfigProblem& problem) {
  return problem.key == kInclude && problem.text.find(kNotFound) != std::string::npos;
}

PlugResult ExpandPlugs(std::string_view text, const fs::path& file, const PlugOptions& options) {
  return Expander(options).Run(text, file);
}

std::vector<fs::path> PlugFoldersAround(const fs::path& file) {
  std::vector<fs::path> absolute;
  std::error_code ignored;
  AddFoldersAbove(fs::absolute(file, ignored).lexically_normal().parent_path(), "plugs", absolute);
  AddFoldersOfProgram("plugs", absolute);
  std::vector<fs::path> folders;
  folders.reserve(absolute.size());
  for (const fs::path& folder : absolute) {
    const fs::path near = fs::proximate(folder, ignored);
    folders.push_back(near.string().starts_with("../../..") ? folder : near);  // as it is read best
  }
  return folders;
}

}  // namespace limpet
