// SPDX-License-Identifier: MIT
#include "limpet/log_tools/log_input.hpp"

#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/core/interrupt.hpp"
#include "limpet/logbook/logs_below.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kBytesWorthProgress = std::uintmax_t{200} << 20U;
constexpr std::uint64_t kLinesPerLook = 1U << 14U;

/// The one log in a folder, or in the folders below it, as a run has them.
fs::path LogIn(const fs::path& folder) {
  const std::vector<fs::path> logs = LogsBelow(folder);
  if (logs.size() == 1) {
    return logs[0];
  }
  std::string names;
  for (const fs::path& log : logs) {
    names += "\n  " + log.string();
  }
  throw std::runtime_error(
      logs.empty() ? fmt::format("{}: holds no .alog file", folder.string())
                   : fmt::format("{}: holds several logs; which one?{}", folder.string(), names));
}

fs::path FileOf(const std::string& name) {
  if (name == "-") {
    return "/dev/stdin";
  }
  return fs::is_directory(name) ? LogIn(name) : fs::path(name);
}

AlogReader OpenOrThrow(const fs::path& file) {
  Expected<AlogReader> reader = AlogReader::Open(file);
  if (!reader) {
    throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  }
  return *std::move(reader);
}

std::optional<std::uintmax_t> SizeOfFile(const fs::path& file) {
  std::error_code failure;
  const std::uintmax_t size = fs::is_regular_file(file, failure) ? fs::file_size(file, failure) : 0;
  return failure || size == 0 ? std::nullopt : std::optional<std::uintmax_t>(size);
}

}  // namespace

LogInput::LogInput(const std::string& name)
    : file_(FileOf(name)), reader_(OpenOrThrow(file_)), size_(SizeOfFile(file_)) {
  if (size_ && *size_ > kBytesWorthProgress) {
    progress_.emplace(file_.filename().string());
  }
}

bool LogInput::Next(AlogLine& line, AlogEntry& entry) {
  if (++lines_ % kLinesPerLook == 0) {
    ShowProgress();
  }
  if (reader_.NextLine(line, entry)) {
    return true;
  }
  progress_.reset();
  if (reader_.has_failed()) {
    throw std::runtime_error(fmt::format("{}: cannot be read to its end", file_.string()));
  }
  return false;
}

void LogInput::ShowProgress() {
  if (interrupt_requested) {
    throw std::runtime_error("interrupted");
  }
  if (progress_) {
    const double done = static_cast<double>(reader_.position()) / static_cast<double>(*size_);
    progress_->Update(done,
                      fmt::format("{:.1f} GB", static_cast<double>(reader_.position()) / 1e9));
  }
}

void LogInput::PrintDoubts() const {
  for (const AlogReader::Skipped& skipped : reader_.first_skipped()) {
    fmt::print(stderr, "{}:{}: no entry: {}\n", OneLine(file_.string()), skipped.line,
               skipped.problem);
  }
  if (const std::size_t shown = reader_.first_skipped().size(); reader_.skipped_lines() > shown) {
    fmt::print(stderr, "{}: {} further lines are no entries\n", OneLine(file_.string()),
               reader_.skipped_lines() - shown);
  }
  if (reader_.has_torn_end()) {
    fmt::print(stderr, "{}: the last line is torn and was left out\n", OneLine(file_.string()));
  }
}

}  // namespace limpet
