// SPDX-License-Identifier: MIT
// A log whose entries are known, and the commands of `limpet log` as a user runs them.
#pragma once

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limpet/console/command_output.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/core/random.hpp"
#include "limpet/log_tools/log_commands.hpp"

namespace limpet {

struct MadeEntry {
  double time = 0.0;
  std::string name, source, value;
  bool is_number = false;
  double number = 0.0;
  [[nodiscard]] std::string Line() const {
    return fmt::format("{:<15.5f} {:<20} {:<15} {} ", time, name, source, value);
  }
};

inline constexpr const char* kMadeBanner = "%% LOGSTART                  1767225600 \n";

/// Times are whole hundredths of a second, so that text keeps them exactly.
inline std::vector<MadeEntry> MakeEntries(Random& random, std::size_t count, bool is_in_order) {
  const std::array<std::string, 5> names{"NAV_X", "NAV_Y", "NAV_HEADING", "MODE", "DB_TIME"};
  const std::array<std::string, 3> sources{"pNav", "pSim", "pHelm"};
  const std::array<std::string, 4> words{"ACTIVE", "a=1,b=2", "say \"no\"", "two  blanks"};
  std::vector<MadeEntry> entries;
  std::uint64_t hundredths = random.Index(500);
  for (std::size_t i = 0; i < count; ++i) {
    hundredths += random.Index(40);
    const std::uint64_t late = is_in_order || !random.Chance(0.1) ? 0 : random.Index(90);
    MadeEntry entry{.time = static_cast<double>(hundredths - std::min(late, hundredths)) / 100.0,
                    .name = names[random.Index(names.size())],
                    .source = sources[random.Index(sources.size())],
                    .value = words[random.Index(words.size())],
                    .is_number = random.Chance(0.7)};
    if (entry.is_number) {
      entry.number = (static_cast<double>(random.Index(200000)) - 100000.0) / 1000.0;
      entry.value = fmt::format("{:.3f}", entry.number);
    }
    entries.push_back(entry);
  }
  return entries;
}

inline std::string LogTextOf(const std::vector<MadeEntry>& entries) {
  std::string text = kMadeBanner;
  for (const MadeEntry& entry : entries)
    text += entry.Line() + "\n";
  return text;
}

inline std::string BytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline std::filesystem::path WriteLog(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

inline std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

struct LogRun {
  int code = kOk;
  std::string out, err;  ///< a complaint that the command line would print stands in `err`, too
};

inline LogRun RunLogCommand(const LogCommand& command, const std::vector<std::string>& words) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  LogRun run;
  std::string complaint;
  try {
    run.code = RunCommand(command.form(), words, command.run);
  } catch (const UsageError& error) {
    run.code = kUsage;
    complaint = error.what();
  } catch (const Refusal& error) {
    run.code = kRefused;
    complaint = error.what();
  } catch (const std::exception& error) {
    run.code = kFailed;
    complaint = error.what();
  }
  std::fflush(stdout);
  run.out = ::testing::internal::GetCapturedStdout();
  run.err = ::testing::internal::GetCapturedStderr() + complaint;
  return run;
}

}  // namespace limpet
