// SPDX-License-Identifier: MIT
// The tools as commands: `limpet scope`, `poke`, `play`, `status`, and the programs uScope, uPoke
// and uPlay, which are the same. `caller` is what help and complaints call it. Exit codes: 0 ok,
// 1 failed, 2 command line, mission file, or no community; they end on SIGINT and SIGTERM.
#pragma once

#include <span>
#include <string>

namespace limpet {

/// Shows variables live; plain lines when piped.
[[nodiscard]] int RunScope(const std::string& caller, std::span<const std::string> args);
/// Writes variables and reads them back; 1 if the broker refuses one or does not answer.
[[nodiscard]] int RunPoke(const std::string& caller, std::span<const std::string> args);
/// Plays a log into a community; 1 if it was stopped or the community was lost.
[[nodiscard]] int RunPlay(const std::string& caller, std::span<const std::string> args);
/// Says who is up; 1 if one that should be is not.
[[nodiscard]] int RunStatus(const std::string& caller, std::span<const std::string> args);

/// A tool as the whole of a program's main.
using Tool = int (*)(const std::string& caller, std::span<const std::string> args);
[[nodiscard]] int RunToolMain(Tool tool, const std::string& name, int argc,
                              const char* const* argv);

}  // namespace limpet
