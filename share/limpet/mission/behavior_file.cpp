// SPDX-License-Identifier: MIT
#include "limpet/mission/behavior_file.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "limpet/mission/behavior_lines.hpp"
#include "limpet/mission/flag.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/mission_lines.hpp"

namespace limpet {
namespace {

constexpr std::string_view kNameMarks = "_-[]()#@+?";  // besides letters and digits, in names

/// First word without case, and the rest.
bool TakesKeyword(std::string_view text, std::string_view keyword, std::string_view& rest) {
  if (!EqualsIgnoringCase(text.substr(0, keyword.size()), keyword)) {
    return false;
  }
  rest = text.substr(keyword.size());
  const bool is_whole_word = rest.empty() || rest[0] == ' ' || rest[0] == '\t' || rest[0] == '=';
  rest = Trim(rest);
  return is_whole_word;
}

/// Splits at commas that are not inside double quotes.
std::vector<std::string> SplitOutsideQuotes(std::string_view text) {
  std::vector<std::string> parts(1);
  bool is_quoted = false;
  for (const char letter : text) {
    is_quoted = is_quoted != (letter == '"');
    if (letter == ',' && !is_quoted) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

class BehaviorParser {
 public:
  explicit BehaviorParser(std::string file) { result_.file = std::move(file); }

  BehaviorFile Run(const std::vector<TextLine>& lines, std::vector<ConfigProblem> warnings) {
    result_.warnings = std::move(warnings);
    for (const TextLine& line : lines) {
      ParseLine(line);
    }
    if (place_ != Place::kTop && place_ != Place::kAfterMode) {
      Complain(block_.where, block_.name, "has no closing `}`");
    }
    CheckNames();
    if (!problems_.empty()) {
      throw ConfigError(problems_);
    }
    return std::move(result_);
  }

 private:
  enum class Place {
    kTop,
    kBeforeBehavior,
    kInBehavior,
    kBeforeMode,
    kInMode,
    kAfterMode,
    kIgnored  ///< in a block of nothing
  };

  void Complain(const SourceLine& where, std::string key, std::string text) {
    problems_.push_back({where, std::move(key), std::move(text)});
  }

  void ParseLine(const TextLine& line) {
    if (place_ == Place::kAfterMode && TakesElse(line)) {
      return;
    }
    if (line.text.empty()) {
      return;
    }
    switch (place_) {
      case Place::kBeforeBehavior:
        return ExpectBrace(line, Place::kInBehavior);
      case Place::kBeforeMode:
        return ExpectBrace(line, Place::kInMode);
      case Place::kInBehavior:
        return ParseParameter(line);
      case Place::kInMode:
        return ParseModeCondition(line);
      case Place::kIgnored:
        place_ = line.text == "}" ? Place::kTop : Place::kIgnored;
        return;
      default:
        return ParseTop(line);
    }
  }

  /// The word after `}` on the same or the next line; a blank line says there is none.
  bool TakesElse(const TextLine& line) {
    place_ = Place::kTop;
    const bool is_word = line.text.find_first_of("= \t{}") == std::string::npos;
    if (line.text.empty() || !is_word) {
      return line.text.empty();
    }
    result_.modes.back().else_value = line.text;
    return true;
  }

  void ParseTop(const TextLine& line) {
    std::string_view rest;
    if (TakesKeyword(line.text, "initialize_", rest)) {
      ParseInitialize(rest, true, line.where);
    } else if (TakesKeyword(line.text, "initialize", rest)) {
      ParseInitialize(rest, false, line.where);
    } else if (TakesKeyword(line.text, "behavior", rest)) {
      OpenBehavior(rest, line.where);
    } else if (TakesKeyword(line.text, "set", rest)) {
      OpenMode(rest, line.where);
    } else if (line.text == "{") {  // most likely its `Behavior = ...` is commented out
      block_ = {.name = "{", .where = line.where, .entries = {}};
      place_ = Place::kIgnored;
      result_.warnings.push_back(
          {line.where, "{", "a block without `Behavior = ...` before it; ignored to its `}`"});
    } else {
      const std::string word(Trim(line.text.substr(0, line.text.find_first_of(" \t="))));
      const std::string nearest = NearestWord(word, {"initialize", "behavior", "set"});
      Complain(line.where, word,
               fmt::format("unknown text `{}`{}", line.text,
                           nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
    }
  }

  void ParseInitialize(std::string_view text, bool is_deferred, const SourceLine& where) {
    for (const std::string& part : SplitOutsideQuotes(text)) {
      const KeyValue pair = SplitKeyValue(part);
      if (pair.key.empty() || pair.key.find_first_of(" \t") != std::string::npos) {
        Complain(where, "initialize", fmt::format("`{}` is not VARIABLE = value", Trim(part)));
        continue;
      }
      result_.initializes.push_back({pair.key, ValueOfText(pair.value), is_deferred, where});
    }
  }

  void OpenBehavior(std::string_view rest, const SourceLine& where) {
    const KeyValue pair = SplitKeyValue(rest);
    block_ = {.name = pair.value, .where = where, .entries = {}};
    place_ = Place::kBeforeBehavior;
    if (!pair.has_equals || !pair.key.empty() || pair.value.empty()) {
      Complain(where, "Behavior", "needs a type, as in `Behavior = BHV_CoverArea`");
    }
  }

  void OpenMode(std::string_view rest, const SourceLine& where) {
    const KeyValue pair = SplitKeyValue(rest);
    const auto has_blank = [](std::string_view text) {
      return text.empty() || text.find_first_of(" \t") != std::string_view::npos;
    };
    block_ = {.name = "set " + pair.key, .where = where, .entries = {}};
    result_.modes.push_back({pair.key, pair.value, {}, "", where});
    place_ = Place::kBeforeMode;
    if (rest.find('{') != std::string_view::npos) return RefuseModeOfOneLine(rest, where);
    if (has_blank(pair.key) || has_blank(pair.value)) {
      Complain(where, "set", fmt::format("`{}` is not VARIABLE = VALUE", rest));
    }
  }

  /// `set MODE = A { X = true } B`: what comes after it is read as if it stood on lines of its own.
  void RefuseModeOfOneLine(std::string_view rest, const SourceLine& where) {
    Complain(where, "set",
             fmt::format("`{}` is not allowed in one line; allowed: `{{` at the end of the first "
                         "line or alone, each condition on a line of its own, and `}}` before the "
                         "value that holds else",
                         rest));
    const bool is_closed = rest.find('}') != std::string_view::npos;
    const bool has_else = is_closed && !rest.ends_with('}');
    place_ = has_else ? Place::kTop : is_closed ? Place::kAfterMode : Place::kInMode;
  }

  void ExpectBrace(const TextLine& line, Place next) {
    place_ = next;
    if (line.text != "{") {
      Complain(line.where, block_.name, fmt::format("`{{` must come before `{}`", line.text));
      place_ = Place::kTop;
      ParseLine(line);
    }
  }

  void ParseParameter(const TextLine& line) {
    KeyValue pair = SplitKeyValue(line.text);
    if (line.text == "}") {
      result_.behaviors.push_back(std::move(block_));
      place_ = Place::kTop;
    } else if (line.text == "{" || EqualsIgnoringCase(pair.key, "behavior")) {
      Complain(line.where, block_.name,
               fmt::format("`{}` inside a block; is a `}}` missing above?", line.text));
    } else if (line.text.starts_with("# ")) {
      result_.warnings.push_back(
          {line.where, "#", "is no comment in behavior files (`//` is); ignored"});
    } else if (!pair.has_equals || pair.key.empty()) {
      Complain(line.where, block_.name,
               fmt::format("`{}` is neither a comment (//) nor `parameter = value`", line.text));
    } else if (pair.value.ends_with('}') && pair.value.find('{') == std::string::npos) {
      Complain(line.where, pair.key,
               "a `}` after a value does not close the block: give it a line");
    } else {
      pair.key.erase(0, pair.key.starts_with('_') ? 1 : 0);
      block_.entries.push_back({pair.key, pair.value, line.where});
    }
  }

  void ParseModeCondition(const TextLine& line) {
    if (line.text == "}") {
      place_ = Place::kAfterMode;
      return;
    }
    Expected<Condition> condition = Condition::Parse(line.text);
    if (!condition) {
      Complain(line.where, block_.name, condition.error().text);
    } else if (const auto* plain = condition->comparison(); plain != nullptr && plain->op == "==") {
      Complain(line.where, block_.name, "`==` is not allowed in a mode declaration; use `=`");
    } else {
      result_.modes.back().conditions.push_back(*std::move(condition));
    }
  }

  void CheckNames() {
    std::vector<std::string> names;
    for (const ConfigBlock& block : result_.behaviors) {
      const ConfigEntry* entry = block.Find("name");
      const std::string name = BehaviorNameOf(block);
      const bool is_macro = name.find("$(") != std::string::npos ||
                            name.find("%(") != std::string::npos;  // nsplug knows both
      if (is_macro) continue;                                      // whoever runs it refuses it
      const SourceLine& where = entry != nullptr ? entry->where : block.where;
      const bool is_allowed = std::ranges::all_of(name, [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
               kNameMarks.find(letter) != std::string_view::npos;
      });
      if (!is_allowed) {
        Complain(
            where, "name",
            fmt::format("`{}` is not allowed; allowed: letters, digits and {}", name, kNameMarks));
      }
      if (std::ranges::find(names, name) != names.end()) {
        Complain(where, "name", fmt::format("`{}` is the name of two behaviors", name));
      }
      names.push_back(name);
    }
  }

  BehaviorFile result_;
  std::vector<ConfigProblem> problems_;
  Place place_ = Place::kTop;
  ConfigBlock block_;  ///< being read; of a mode only name and place
};

}  // namespace

std::string BehaviorNameOf(const ConfigBlock& block) {
  const ConfigEntry* entry = block.Find("name");
  return entry != nullptr ? entry->value : block.name;
}

BehaviorFile ParseBehaviors(std::string_view text, const std::string& file) {
  return ParseBehaviors(text, file, MissionPlugOptions(file));
}

BehaviorFile ParseBehaviors(std::string_view text, const std::string& file,
                            const PlugOptions& options) {
  std::vector<ConfigProblem> warnings;
  const std::vector<TextLine> lines = ConfigLines(text, file, options, warnings);
  return BehaviorParser(file).Run(BehaviorLines(lines), std::move(warnings));
}

BehaviorFile LoadBehaviors(const std::filesystem::path& file) {
  return ParseBehaviors(ReadTextFile(file), file.string());
}

}  // namespace limpet
