// SPDX-License-Identifier: MIT
#include "limpet/console/tool_frame.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/app/run_app.hpp"
#include "limpet/console/community.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/console/tools.hpp"

namespace limpet {

int RunTool(const Command& command, std::span<const std::string> args,
            const std::function<int(const Arguments&)>& work) {
  const std::string& caller = command.name;
  try {
    return RunCommand(command, args, [&work](const Arguments& given) {
      CatchEndSignals();
      return work(given);
    });
  } catch (const UsageError& error) {
    fmt::print(stderr, "{}: {}; --help says more\n", caller, ShownLines(error.what()));
    return kUsage;
  } catch (const ConfigError& error) {
    fmt::print(stderr, "{}\n", ShownLines(error.what()));
    return kUsage;
  } catch (const NoCommunity& error) {
    fmt::print(stderr, "{}: {}\n", caller, OneLine(error.what(), kAnyWidth, TerminalReadsUtf8()));
    return kUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", caller, OneLine(error.what(), kAnyWidth, TerminalReadsUtf8()));
    return kFailed;
  }
}

void PrintFrame(const Frame& frame) {
  const bool has_ink = ::isatty(STDOUT_FILENO) != 0;
  const bool keeps_utf8 = TerminalReadsUtf8();
  for (FrameLine line : frame) {
    if (!keeps_utf8) {
      line.MakeAscii();
    }
    fmt::print("{}\n", has_ink ? Painted(line, ColorsAreWanted()) : line.PlainText());
  }
  std::fflush(stdout);
}

ToolWords Sorted(const std::vector<std::string>& positionals) {
  ToolWords words;
  for (const std::string& word : positionals) {
    (IsMissionName(word) ? words.missions : words.others).push_back(word);
  }
  if (words.missions.size() > 1) {
    throw UsageError(
        fmt::format("{} and {}: one mission at most", words.missions[0], words.missions[1]));
  }
  return words;
}

int RunToolMain(Tool tool, const std::string& name, int argc, const char* const* argv) {
  const std::vector<std::string> args(argv + 1, argv + argc);
  return tool(name, args);
}

}  // namespace limpet
