// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/plug.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
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

Command PlugForm() {
  return {
      .name = "limpet plug",
      .words = "<in> <out> [MACRO=value ...] [MACRO ...]",
      .about =
          R"(Expands a template into a mission, as nsplug does: #include, #define, #ifdef, #ifndef,
#elseifdef, #else, #endif; $(M) a macro's value, %(M) in upper case, $(M=x) x if M is undefined,
$(M:=x) x if M is undefined or empty. MACRO alone is as `#define MACRO`: #ifdef MACRO holds, and it
stands for nothing. After MACRO= it does not hold, nor does #ifndef count it as defined.)",
      .options =
          {{.names = "-f,--force",
            .meaning = "write over <out>; otherwise a person is asked, and without one it is "
                       "refused"},
           {.names = "-s,--strict",
            .meaning = "an undefined macro is an error, and nothing is written"},
           {.names = "-l,--lenient",
            .meaning = "expand the defined macros of a line that has undefined ones too (default: "
                       "such a line is left as it is, with a warning)"},
           {.names = "-i,--interactive", .meaning = "ask whether to go on at each undefined macro"},
           {.names = "-I", .meaning = "the same, but only `y` goes on"},
           {.names = "-p,--path",
            .value = "DIR:DIR",
            .meaning = "where #include looks, after the folder of <in> and the current one; then "
                       "come the folders called plugs above them",
            .is_repeatable = true},
           {.names = "--macros",
            .value = "FILE",
            .meaning = "NAME=value lines",
            .is_repeatable = true},
           {.names = "--tag", .value = "NAME", .meaning = "only that <tag> section of <in>"},
           {.names = "-x,--xfile",
            .meaning = "take <in>x (e.g. meta.moosx) instead, if there is one"},
           {.names = "-t,--terminal", .meaning = "print the result; <out> must still be named"}},
      .more = R"(Exit code 2 if the template is wrong, 3 if <out> must not be written.

  limpet plug meta_vehicle.moos targ_alpha.moos -f VNAME=alpha SHARE_PORT=9201)",
      .takes = "an input and an output file",
      .least_words = 2};
}

struct PlugCommand {
  std::vector<std::string> files;  ///< input, output
  PlugOptions options;
  bool may_overwrite = false;
  bool prints = false;
  bool takes_xfile = false;
  bool asks = false;
  bool goes_on_by_default = true;  ///< what an empty answer means
};

/// `NAME=value`, `NAME=` (empty: `#ifdef NAME` does not hold), `NAME` (as `#define NAME`).
PlugOptions::Macro MacroOf(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
  return {.name = std::string(Trim(word.substr(0, equals))),
          .value = std::string(Trim(value)),
          .is_set_empty = equals != std::string::npos && Trim(value).empty()};
}

PlugOptions OptionsOf(const Arguments& given) {
  using Undefined = PlugOptions::Undefined;
  PlugOptions options;
  if (given.Has("lenient")) options.undefined = Undefined::kKeepMacro;
  if (given.Has("strict")) options.undefined = Undefined::kRefuse;
  for (const std::string& folders : given.All("path")) {
    for (const std::string& folder : Split(folders, ':')) {
      if (!folder.empty()) options.search_folders.emplace_back(folder);
    }
  }
  for (const std::string& file : given.All("macros"))
    options.macro_files.emplace_back(file);
  options.tag = given.Find("tag").value_or("");
  const auto macros = std::span(given.positionals()).subspan(2);
  std::ranges::transform(macros, std::back_inserter(options.macros), MacroOf);
  return options;
}

PlugCommand ReadPlugCommand(const Arguments& given) {
  return {.files = {given.positionals()[0], given.positionals()[1]},
          .options = OptionsOf(given),
          .may_overwrite = given.Has("force"),
          .prints = given.Has("terminal"),
          .takes_xfile = given.Has("xfile"),
          .asks = given.Has("interactive") || given.Has("I"),
          .goes_on_by_default = !given.Has("I")};
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
    const bool is_undefined = warning.key.starts_with("$(") || warning.key.starts_with("%(");
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
  return RunCommand(PlugForm(), args,
                    [](const Arguments& given) { return Expand(ReadPlugCommand(given)); });
}

}  // namespace limpet
