// SPDX-License-Identifier: MIT
#include "limpet/console/command.hpp"

#include <fmt/format.h>

#include "limpet/console/exit_code.hpp"

namespace limpet {

int RunCommand(const Command& command, std::span<const std::string> words,
               const std::function<int(const Arguments&)>& work) {
  const Arguments given = ReadArguments(command, words);
  if (given.Has("help")) {
    fmt::print("{}", HelpText(command));
    return kOk;
  }
  return work(given);
}

}  // namespace limpet
