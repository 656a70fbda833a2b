// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/plug.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/limpet/cli.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/core/config.hpp"
#include "limpet/mission/plug.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPlugHelp =
    R"(usage: limpet plug <in> <out> [options] [MACRO=value ...] [MACRO ...]

Expands a template into a mission, as nsplug does: #include, #define, #ifdef, #ifndef, #elseifdef,
#else, #endif; $(M) a macro's value, %(M) in upper case, $(M=x) x if M is undefined, $(M:=x) x if M is
undefined or empty. MACRO alone is as `#define MACRO`: #ifdef MACRO holds, and it stands for nothing.
After MACRO= it does not hold, nor does #ifndef count it as defined.

  -f, --force         write over <out>; otherwise a person is asked, and without one it is refused
  -s, --strict        an undefined macro is an error, and nothing is written
  -l, --lenient       expand the defined macros of a line that has undefined ones too
                      (default: such a line is left as it is, with a warning)
  -i, --interactive   ask whether to go on at each undefined macro; -I: only `y` goes on
  -p DIR, --path=DIR:DIR   where #include looks, after the folder of <in> and the current one;
                      then come the folders called plugs above them
  --macros=FILE       NAME=value lines; repeatable
  --tag=NAME          only that <tag> section of <in>
  -x, --xfile         take <in>x (e.g. meta.moosx) instead, if there is one
  -t, --terminal      print the result; <out> must still be named

Exit code 2 if the template is wrong, 3 if <out> must not be written.

  limpet plug meta_vehicle.moos targ_alpha.moos -f VNAME=alpha SHARE_PORT=9201
)";

struct PlugCommand {
  std::vector<std::string> files;  ///< input, output
  PlugOptions options;
  bool may_overwrite = false;
  bool prints = false;
  bool takes_xfile = false;
  bool asks = false;
  bool goes_on_by_default = true;  ///< what an empty answer means
  bool wants_help = false;
};

struct Switch {
  const char* brief;
  const char* full;
  std::function<void(PlugCommand&)> set;
};

const std::array<Switch, 8>& Switches() {
  using Undefined = PlugOptions::Undefined;
  static const std::array<Switch, 8> switches{{
      {"-f", "--force", [](PlugCommand& c) { c.may_overwrite = true; }},
      {"-s", "--strict", [](PlugCommand& c) { c.options.undefined = Undefined::kRefuse; }},
      {"-l", "--lenient", [](PlugCommand& c) { c.options.undefined = Undefined::kKeepMacro; }},
      {"-i", "--interactive", [](PlugCommand& c) { c.asks = true; }},
      {"-I", "-I", [](PlugCommand& c) { c.asks = true, c.goes_on_by_default = false; }},
      {"-x", "--xfile", [](PlugCommand& c) { c.takes_xfile = true; }},
      {"-t", "--terminal", [](PlugCommand& c) { c.prints = true; }},
      {"-h", "--help", [](PlugCommand& c) { c.wants_help = true; }},
  }};
  return switches;
}

void AddFolders(PlugCommand& command, const std::string& folders) {
  for (const std::string& folder : Split(folders, ':')) {
    if (!folder.empty()) {
      command.options.search_folders.emplace_back(folder);
    }
  }
}

bool TakeSwitch(PlugCommand& command, const std::string& word) {
  for (const Switch& known : Switches()) {
    if (word == known.brief || word == known.full) {
      known.set(command);
      return true;
    }
  }
  return false;
}

/// Options that carry a value after `=`.
bool TakeValued(PlugCommand& command, const std::string& word) {
  const std::size_t equals = word.find('=');
  if (!word.starts_with("--") || equals == std::string::npos) {
    return false;
  }
  const std::string name = word.substr(0, equals);
  const std::string value = word.substr(equals + 1);
  if (name == "--path") {
    AddFolders(command, value);
  } else if (name == "--macros") {
    command.options.macro_files.emplace_back(value);
  } else if (name == "--tag") {
    command.options.tag = value;
  } else {
    return false;
  }
  return true;
}

[[noreturn]] void RefuseOption(const std::string& word) {
  std::vector<std::string> known{"--path", "--macros", "--tag"};
  for (const Switch& option : Switches()) {
    known.emplace_back(option.full);
  }
  const std::string nearest = NearestWord(word.substr(0, word.find('=')), known);
  throw UsageError(fmt::format("unknown option {}{}", word,
                               nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
}

/// `NAME=value`, `NAME=` (empty: `#ifdef NAME` does not hold), `NAME` (as `#define NAME`).
PlugOptions::Macro MacroOf(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
  return {.name = std::string(Trim(word.substr(0, equals))),
          .value = std::string(Trim(value)),
          .is_set_empty = equals != std::string::npos && Trim(value).empty()};
}

PlugCommand Parse(std::span<const std::string> args) {
  PlugCommand command;
  for (std::size_t i = 0; i < args.size(); ++i) {
    const std::string& word = args[i];
    if ((word == "-p" || word == "--path") && i + 1 < args.size()) {
      AddFolders(command, args[++i]);
    } else if (TakeSwitch(command, word) || TakeValued(command, word)) {
      continue;
    } else if (word.size() > 1 && word[0] == '-') {
      RefuseOption(word);
    } else if (command.files.size() < 2) {
      command.files.push_back(word);
    } else {
      command.options.macros.push_back(MacroOf(word));
    }
  }
  return command;
}

/// Asks a person; without one the answer is no.
bool Confirms(const std::string& question, bool is_yes_default) {
  if (isatty(STDIN_FILENO) == 0) {
    return false;
  }
  fmt::print(stderr, "{} [{}] ", question, is_yes_default ? "Y/n" : "y/N");
  std::string answer;
  if (!std::getline(std::cin, answer)) {
    return false;
  }
  return answer.empty() ? is_yes_default : answer[0] == 'y' || answer[0] == 'Y';
}

fs::path InputOf(const PlugCommand& command) {
  const fs::path with_x = command.files[0] + "x";
  return command.takes_xfile && fs::exists(with_x) ? with_x : fs::path(command.files[0]);
}

/// Prints the warnings; false if a person wants to stop at one.
bool AcceptsWarnings(const PlugCommand& command, const PlugResult& result) {
  for (const ConfigProblem& warning : result.warnings) {
    fmt::print(stderr, "warning: {}\n", warning.Format());
    const bool is_undefined = warning.key.starts_with("$(");
    if (command.asks && is_undefined && !Confirms("go on?", command.goes_on_by_default)) {
      return false;
    }
  }
  return true;
}

int Expand(PlugCommand command) {
  const fs::path input = InputOf(command);
  command.options.search_folders.insert(command.options.search_folders.begin(), ".");
  for (const fs::path& folder : PlugFoldersAround(input)) {
    command.options.search_folders.push_back(folder);
  }
  const PlugResult result = ExpandPlugs(ReadTextFile(input), input, command.options);
  if (!AcceptsWarnings(command, result)) {
    throw Refusal("an undefined macro was not accepted; nothing is written");
  }
  const std::string& name = command.files[1];
  const bool may_overwrite = command.may_overwrite || command.prints || !fs::exists(name) ||
                             Confirms(fmt::format("{} exists; write over it?", name), false);
  CommandOutput output(command.prints ? std::nullopt : std::optional(name), may_overwrite, input);
  for (const TextLine& line : result.lines) {
    output.Write(line.text + "\n");
  }
  output.Commit();
  if (!command.prints && !command.may_overwrite) {
    fmt::print("{}: {} lines\n", name, result.lines.size());
  }
  return kOk;
}

}  // namespace

int RunPlug(std::span<const std::string> args) {
  PlugCommand command = Parse(args);
  if (command.wants_help) {
    fmt::print("{}", kPlugHelp);
    return kOk;
  }
  if (command.files.size() < 2) {
    throw UsageError("plug takes an input and an output file");
  }
  try {
    return Expand(std::move(command));
  } catch (const Refusal& refusal) {
    fmt::print(stderr, "limpet: {}\n", refusal.what());
    return kRefused;
  }
}

}  // namespace limpet
