// SPDX-License-Identifier: MIT
// What a command takes, declared once: its help, its complaints and its reading all come from that.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "limpet/console/arguments.hpp"
#include "limpet/console/value_rule.hpp"

namespace limpet {

/// An option: `--name value`, `--name=value`, or a flag.
struct CommandOption {
  std::string names;       ///< `--out`, `-p,--path`; code asks for it by the first long one
  std::string value{};     ///< what stands for its value in the help: `DIR`; empty: it is a flag
  std::string meaning{};   ///< for the help, from a small letter, without a full stop
  std::string fallback{};  ///< its value if it is not given; empty: none
  ValueRule rule{};
  bool is_required = false;
  bool is_repeatable = false;  ///< else the last value given counts
};

struct Command {
  std::string name;     ///< with what calls it: `limpet survey`, `uPoke`
  std::string words{};  ///< what stands for its words in the usage: `<mission folder>`
  std::string about{};  ///< paragraphs, wrapped in the help; indented lines stay as they are
  std::vector<CommandOption> options{};
  std::string more{};   ///< as `about`, behind the options
  std::string takes{};  ///< the complaint if words or a required option lack: `survey takes
                        ///< one mission folder`
  std::size_t least_words = 0;
  std::size_t most_words = std::numeric_limits<std::size_t>::max();
};

/// Reads the words behind a command's name. Throws UsageError, which names what is wrong and the
/// nearest known option. No complaint where help is asked for.
[[nodiscard]] Arguments ReadArguments(const Command& command, std::span<const std::string> words);

/// `command --help`, at most 80 columns wide.
[[nodiscard]] std::string HelpText(const Command& command);

/// Prints the help if it is asked for, else does the work: the exit code. Throws UsageError.
[[nodiscard]] int RunCommand(const Command& command, std::span<const std::string> words,
                             const std::function<int(const Arguments&)>& work);

}  // namespace limpet
