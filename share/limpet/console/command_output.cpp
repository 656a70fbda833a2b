// SPDX-License-Identifier: MIT
#include "limpet/console/command_output.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/console/shown_text.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferBytes = std::size_t{256} << 10U;

}  // namespace

CommandOutput::CommandOutput(const std::optional<std::string>& name, bool may_overwrite,
                             const fs::path& input) {
  if (!name) {
    is_terminal_ = isatty(STDOUT_FILENO) != 0;
    return;
  }
  if (*name == "-") {
    throw Refusal(
        "-: is no name for a file; a command that writes to the standard output does so "
        "without --out");
  }
  path_ = *name;
  aside_ = *name + ".part";
  std::error_code ignored;
  if (fs::is_directory(path_, ignored)) {
    throw Refusal(fmt::format("{}: is a folder, not a file", path_.string()));
  }
  if (fs::equivalent(path_, input, ignored)) {
    throw Refusal(fmt::format("{}: is the file that is read", path_.string()));
  }
  if (fs::exists(path_, ignored) && !may_overwrite) {
    throw Refusal(fmt::format("{}: exists; --force writes over it", path_.string()));
  }
  Expected<AppendFile> file = AppendFile::Create(aside_);
  if (!file) {
    throw std::runtime_error(file.error().text);
  }
  file_ = *std::move(file);
}

CommandOutput::~CommandOutput() {
  if (file_) {
    std::error_code ignored;
    fs::remove(aside_, ignored);
  }
}

void CommandOutput::Write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() > kBufferBytes) {
    HandOver();
  }
}

void CommandOutput::WriteLines(std::string_view text) {
  if (is_terminal_) {
    Write(ShownLines(text, TerminalReadsUtf8()));
  } else {
    Write(text);
  }
  Write("\n");
}

void CommandOutput::HandOver() {
  const bool is_good =
      file_ ? file_->Append(buffer_)
            : std::fwrite(buffer_.data(), 1, buffer_.size(), stdout) == buffer_.size();
  if (!is_good) {
    throw std::runtime_error(
        fmt::format("{}: cannot be written", file_ ? path_.string() : "standard output"));
  }
  buffer_.clear();
}

void CommandOutput::Commit() {
  HandOver();
  if (!file_) {
    std::fflush(stdout);
    return;
  }
  if (!file_->Sync()) {
    throw std::runtime_error(fmt::format("{}: cannot be written", path_.string()));
  }
  fs::rename(aside_, path_);
  // A folder that cannot be synced leaves the file where it is, whole: nothing to complain of.
  static_cast<void>(RealFileSystem().SyncFolder(path_.parent_path()));
  file_.reset();
}

}  // namespace limpet
