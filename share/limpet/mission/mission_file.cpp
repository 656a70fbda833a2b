// SPDX-License-Identifier: MIT
#include "limpet/mission/mission_file.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config_entries.hpp"
#include "limpet/core/problem_order.hpp"
#include "limpet/mission/fact_files.hpp"
#include "limpet/mission/mission_lines.hpp"
#include "limpet/mission/mission_places.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/mission/stand_ins.hpp"

namespace limpet {
namespace {

constexpr std::size_t kPeerLineBytes = 2000;  // MOOS stops reading the file at such a line

/// Braces opened less those closed, outside of quotes.
int NetBraces(std::string_view text) {
  int net = 0;
  bool is_quoted = false;
  for (const char letter : text) {
    is_quoted = is_quoted != (letter == '"');
    net += !is_quoted && letter == '{' ? 1 : 0;
    net -= !is_quoted && letter == '}' ? 1 : 0;
  }
  return net;
}

class MissionParser {
 public:
  explicit MissionParser(std::string file) { mission_.file = std::move(file); }

  MissionFile Run(const std::vector<TextLine>& lines, std::vector<ConfigProblem> warnings) {
    mission_.warnings = std::move(warnings);
    variables_.Learn(lines);
    for (const TextLine& line : lines) {
      ParseLine(line);
    }
    RequireNestedEnded();
    if (place_ != Place::kTop) {
      ComplainInBlock(block_.where, "the block has no closing `}`");
      CloseBlock();
    }
    ParseLaunches();
    SpreadUndefined();
    if (!problems_.empty()) {
      throw ConfigError(problems_);
    }
    SpreadGlobals();
    return std::move(mission_);
  }

 private:
  enum class Place { kTop, kBeforeBrace, kBlock };

  void Complain(const SourceLine& where, std::string key, std::string text) {
    problems_.push_back({where, std::move(key), std::move(text)});
  }
  void ComplainInBlock(const SourceLine& where, std::string text) {
    block_.problems.push_back({where, block_.name, std::move(text)});
  }
  void WarnOf(const SourceLine& where, std::string key, std::string text) {
    mission_.warnings.push_back({where, std::move(key), std::move(text)});
  }

  void ParseLine(const TextLine& raw) {
    if (raw.text.size() >= kPeerLineBytes) {
      WarnOf(raw.where, "", "a line of 2000 bytes or more: MOOS would read no further");
    }
    // MOOS's helm reads its own block with quotes left in place.
    const bool keeps_quotes = place_ == Place::kBlock && block_.name.starts_with("pHelm");
    const bool had_quotes = raw.text.find('"') != std::string::npos;
    TextLine line{CleanMissionLine(raw.text, keeps_quotes), raw.where};
    if (line.text.empty() || SkipsNested(raw, line)) {
      return;
    }
    line.text = variables_.Substitute(line, place_ == Place::kTop ? undefined_ : block_.problems);
    switch (place_) {
      case Place::kTop:
        ParseTop(line, had_quotes);
        break;
      case Place::kBeforeBrace:
        ParseBrace(line);
        break;
      case Place::kBlock:
        ParseInBlock(line);
        break;
    }
  }

  /// Text nested in braces is for others: it is passed over up to the `}` that ends it, or to the
  /// next block where none does.
  bool SkipsNested(const TextLine& raw, const TextLine& line) {
    if (IsBlockHeader(SplitKeyValue(line.text).key)) {
      RequireNestedEnded();
      return false;
    }
    const int net = NetBraces(CleanMissionLine(raw.text, true));
    if (nested_ > 0) {
      nested_ += net;
      if (nested_ < 0 && place_ == Place::kBlock) {
        CloseBlock();  // `}}` ends the block too
      }
      nested_ = std::max(nested_, 0);
      return true;
    }
    const bool may_open = place_ == Place::kTop || place_ == Place::kBlock;
    if (!may_open || net <= 0 || !(line.text.ends_with('{') || line.text.starts_with('{'))) {
      return false;
    }
    nested_ = net;
    if (place_ == Place::kTop) {
      nested_since_ = line.where;
      WarnOf(line.where, line.text, "opens nested text outside of blocks; ignored to its `}`");
    } else {
      ComplainInBlock(line.where,
                      "a `{` inside the block: nested text is not read; is a `}` missing above?");
    }
    return true;
  }

  /// Outside of blocks an open brace would swallow globals; in a block its own end is missing too.
  void RequireNestedEnded() {
    if (nested_ > 0 && place_ == Place::kTop) {
      Complain(nested_since_, "{", "outside of blocks, without a `}` before the next block");
    }
    nested_ = 0;
  }

  void ParseTop(const TextLine& line, bool had_quotes) {
    // `/* ... */` banners are no comments to MOOS either; they survive because it ignores them.
    if (line.text.starts_with("/*") || line.text.starts_with('*')) {
      return;
    }
    KeyValue pair = SplitKeyValue(line.text);
    if (IsBlockHeader(pair.key)) {
      OpenBlock(pair.value, line.where);
    } else if (line.text.starts_with('}')) {
      OnStrayBrace(line);
    } else if (!pair.has_equals || pair.key.empty()) {
      WarnOf(line.where, line.text, "is not `key = value`; ignored");
    } else if (!IsDefine(pair.key) && !pair.value.empty()) {
      if (!had_quotes) {
        std::erase_if(pair.value, [](char letter) { return letter == ' ' || letter == '\t'; });
      }
      mission_.globals.push_back({pair.key, pair.value, line.where});
    }
  }

  /// A `}` too many most likely ended the block before it too early.
  void OnStrayBrace(const TextLine& line) {
    if (mission_.blocks.empty()) {
      WarnOf(line.where, line.text, "a brace without a `ProcessConfig = name` before it; ignored");
      return;
    }
    ConfigBlock& before = mission_.blocks.back();
    before.problems.push_back(
        {line.where, before.name, "a `}` too many; did one above end the block too early?"});
  }

  static bool IsDefine(std::string_view key) {
    constexpr std::string_view kDefine = "define:";
    return EqualsIgnoringCase(key.substr(0, kDefine.size()), kDefine);
  }

  /// Opens the block that `name` begins, also of `ProcessConfig = name {`, which MOOS overlooks.
  void OpenBlock(std::string_view name, const SourceLine& where) {
    const bool has_brace = name.ends_with('{');
    if (has_brace) {
      name = Trim(name.substr(0, name.size() - 1));
      WarnOf(where, std::string(name), "MOOS overlooks a block whose `{` stands on this line");
    }
    block_ = {.name = std::string(name), .where = where, .entries = {}};
    std::erase_if(block_.name, [](char letter) { return letter == ' ' || letter == '\t'; });
    place_ = has_brace ? Place::kBlock : Place::kBeforeBrace;
    if (name.empty()) {
      Complain(where, "ProcessConfig", "needs a name");
    }
  }

  void ParseBrace(const TextLine& line) {
    if (!line.text.starts_with('{')) {
      ComplainInBlock(line.where, fmt::format("`{{` must come before `{}`", line.text));
      CloseBlock();
      ParseTop(line, false);
      return;
    }
    place_ = Place::kBlock;
    const std::string_view rest = Trim(std::string_view(line.text).substr(1));
    if (!rest.empty()) {
      ParseInBlock({std::string(rest), line.where});
    }
  }

  void ParseInBlock(const TextLine& line) {
    KeyValue pair = SplitKeyValue(line.text);
    if (line.text.starts_with('}')) {
      CloseBlock();
    } else if (IsBlockHeader(pair.key)) {
      ComplainInBlock(line.where, "the block has no closing `}` before the next one");
      CloseBlock();
      OpenBlock(pair.value, line.where);
    } else if (line.text.starts_with("# ")) {  // without the blank it may be a misspelt directive
      WarnOf(line.where, "#", "is no comment in mission files (`//` is); ignored");
    } else if (!pair.has_equals || pair.key.empty()) {
      block_.problems.push_back(BareLine(line, block_.name));
    } else if (!IsDefine(pair.key)) {
      const bool has_value =
          !pair.value.empty() || line.text.find_first_of("[]") != std::string::npos;
      if (has_value) {
        block_.entries.push_back({pair.key, pair.value, line.where});
      } else {
        WarnOf(line.where, pair.key, "has no value; ignored");
      }
    }
  }

  void CloseBlock() {
    place_ = Place::kTop;
    if (const ConfigBlock* first = mission_.Block(block_.name)) {
      WarnOf(block_.where, block_.name,
             fmt::format("second block of this name; only the first, {}:{}, counts",
                         first->where.file, first->where.line));
      std::ranges::move(block_.problems, std::back_inserter(mission_.warnings));
      return;
    }
    mission_.blocks.push_back(std::move(block_));
  }

  void ParseLaunches() {
    const ConfigBlock* antler = mission_.Block("ANTLER");
    if (antler == nullptr) {
      return;
    }
    for (const ConfigEntry& entry : antler->entries) {
      if (EqualsIgnoringCase(entry.key, "Run")) {
        ParseLaunch(entry);
      }
    }
  }

  /// Of a global's variable that nothing defines MOOS leaves the bare name: an error to those whose
  /// blocks are read strictly, and to whoever reads a file that launches nothing.
  void SpreadUndefined() {
    if (mission_.launches.empty()) {
      std::ranges::move(undefined_, std::back_inserter(problems_));
      return;
    }
    for (ConfigBlock& block : mission_.blocks) {
      if (StandInFor(ProgramOfBlock(block, mission_)) != nullptr) continue;
      // One refuses an app; all of them in each block would be the square of a file.
      const std::size_t most = EqualsIgnoringCase(block.name, "ANTLER") ? undefined_.size() : 1;
      std::ranges::copy(std::span(undefined_).first(std::min(undefined_.size(), most)),
                        std::back_inserter(block.problems));
    }
    std::ranges::move(undefined_, std::back_inserter(mission_.warnings));
  }

  void SpreadGlobals() {
    for (ConfigBlock& block : mission_.blocks)
      TakeGlobals(mission_.globals, OwnNameOf(ProgramOfBlock(block, mission_)), block);
  }

  /// `binary [@ opt=val, opt=val] [~ name]`.
  void ParseLaunch(const ConfigEntry& run) {
    std::string_view text = run.value;
    LaunchEntry launch{.binary = {}, .moos_name = {}, .options = {}, .where = run.where};
    if (const std::size_t tilde = text.rfind('~'); tilde != std::string_view::npos) {
      launch.moos_name = std::string(Trim(text.substr(tilde + 1)));
      text = text.substr(0, tilde);
    }
    const std::size_t at = text.find('@');
    launch.binary = std::string(Trim(text.substr(0, at)));
    if (at != std::string_view::npos) {
      for (const std::string& option : Split(text.substr(at + 1), ',')) {
        KeyValue pair = SplitKeyValue(option);
        const std::string bare(Trim(option));
        if (!bare.empty()) {  // InhibitMOOSParams and its like stand without a value
          launch.options.push_back({pair.has_equals ? pair.key : bare, pair.value, run.where});
        }
      }
    }
    if (launch.binary.empty()) {
      Complain(run.where, "Run", fmt::format("`{}` names no program", run.value));
      return;
    }
    if (launch.moos_name.empty()) {
      launch.moos_name = std::filesystem::path(launch.binary).filename().string();
    }
    mission_.launches.push_back(std::move(launch));
  }

  MissionFile mission_;
  MissionVariables variables_;
  std::vector<ConfigProblem> problems_;
  std::vector<ConfigProblem> undefined_;  ///< variables of globals
  Place place_ = Place::kTop;
  int nested_ = 0;  ///< braces open inside a block, or outside of blocks
  SourceLine nested_since_;
  ConfigBlock block_;
};

}  // namespace

const ConfigBlock* MissionFile::Block(std::string_view name) const {
  const auto found = std::ranges::find_if(
      blocks, [name](const ConfigBlock& block) { return EqualsIgnoringCase(block.name, name); });
  return found == blocks.end() ? nullptr : &*found;
}

std::string MissionFile::Global(std::string_view key) const {
  const ConfigEntry* global = FindEntry(globals, key);
  return global == nullptr ? "" : global->value;
}

PlugOptions MissionPlugOptions(const std::filesystem::path& file) {
  PlugOptions options;
  options.search_folders = PlugFoldersAround(file);
  options.undefined = PlugOptions::Undefined::kKeepMacro;
  return options;
}

std::vector<TextLine> ConfigLines(std::string_view text, const std::filesystem::path& file,
                                  const PlugOptions& options,
                                  std::vector<ConfigProblem>& warnings) {
  if (auto note = PassByteOrderMark(text, file.string())) warnings.push_back(*std::move(note));
  if (options.macros.empty() && !HasPlugDirective(text)) {
    return SplitLines(text, file.string());
  }
  PlugResult result = ExpandPlugs(text, file, options);
  std::ranges::move(result.warnings, std::back_inserter(warnings));
  return std::move(result.lines);
}

MissionFile ReadMission(std::string_view text, const std::string& file,
                        const PlugOptions& options) {
  std::vector<ConfigProblem> warnings;
  const std::vector<TextLine> lines = ConfigLines(text, file, options, warnings);
  MissionFile mission = MissionParser(file).Run(lines, std::move(warnings));
  TakeFacts(mission);
  TakeStandInLines(mission);
  return mission;
}

MissionFile LoadMission(const std::filesystem::path& file) {
  return ReadMission(ReadTextFile(file), file.string(), MissionPlugOptions(file));
}

MissionFile ParseMission(std::string_view text, const std::string& file) {
  return ParseMission(text, file, MissionPlugOptions(file));
}

MissionFile ParseMission(std::string_view text, const std::string& file,
                         const PlugOptions& options) {
  MissionFile mission = ReadMission(text, file, options);
  std::vector<ConfigProblem> problems;
  for (const ConfigBlock& block : mission.blocks) {
    std::ranges::copy(block.problems, std::back_inserter(problems));
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
  return mission;
}

std::vector<ConfigProblem> NotesOf(const MissionFile& mission,
                                   const std::function<bool(const std::string&)>& is_ours) {
  std::vector<ConfigProblem> notes = mission.warnings;
  for (const ConfigBlock& block : mission.blocks) {
    std::vector<ConfigProblem> own;  // not said of the mission already
    std::ranges::copy_if(
        block.problems, std::back_inserter(own), [&](const ConfigProblem& problem) {
          return std::ranges::none_of(mission.warnings, [&problem](const ConfigProblem& warning) {
            return OrderOf(warning) == OrderOf(problem);
          });
        });
    if (is_ours(block.name) || own.empty()) continue;
    // Of a text that is no list of settings the first line says enough.
    ConfigProblem first = own.front();
    if (const std::size_t more = own.size() - 1; more > 0) {
      first.text += fmt::format(" (and {} more of its lines)", more);
    }
    notes.push_back(std::move(first));
  }
  return notes;
}

std::filesystem::path MissionFileAt(const std::filesystem::path& named) {
  return std::filesystem::is_directory(named) ? named / "mission.moos" : named;
}

}  // namespace limpet
