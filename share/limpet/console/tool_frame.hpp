// SPDX-License-Identifier: MIT
// What every tool does around its work.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "limpet/console/command.hpp"
#include "limpet/console/frame.hpp"

namespace limpet {

/// Prints the help if a word asks for it; else runs `work` and turns what it throws into a
/// complaint on stderr, under the command's name, and an exit code.
[[nodiscard]] int RunTool(const Command& command, std::span<const std::string> args,
                          const std::function<int(const Arguments&)>& work);

/// Prints lines to stdout; with ink if that is a terminal and colours are wanted.
void PrintFrame(const Frame& frame);

/// What a tool was given without a dash: at most one mission, and the rest in order.
struct ToolWords {
  std::vector<std::string> missions;
  std::vector<std::string> others;
};
[[nodiscard]] ToolWords Sorted(const std::vector<std::string>& positionals);

}  // namespace limpet
