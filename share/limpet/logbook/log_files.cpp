// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_files.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/durable/durable_file.hpp"
#include "limpet/logbook/gzip_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytesCopied = std::uintmax_t{64} << 20U;
constexpr std::size_t kRecordOverhead = 128;

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

std::size_t LineSize(const Message& message) {
  const std::size_t value = std::visit(Overloaded{[](double) { return std::size_t{0}; },
                                                  [](const auto& bytes) { return bytes.size(); }},
                                       message.value);
  return message.name.size() + message.source.size() + message.source_aux.size() + value;
}

/// `path` + `_moos` for x.moos; a file without extension becomes x._bak, as with MOOS's logger.
std::string CopyName(const FileCopy& copy) {
  const std::string extension = copy.source.extension().string();
  return (copy.stem.empty() ? copy.source.stem().string() : copy.stem) + "._" +
         (extension.size() < 2 ? "bak" : extension.substr(1));
}

}  // namespace

std::size_t SizeOf(const LogRecord& record) {
  return kRecordOverhead +
         std::visit(Overloaded{[](const LogLine& line) { return LineSize(*line.message); },
                               [](const SyncRow& row) { return row.values.size() * 8; },
                               [](const auto&) { return std::size_t{0}; }},
                    record);
}

Expected<LogFiles> LogFiles::Open(const fs::path& folder, const std::string& stem, Seconds start,
                                  const LogFilesOptions& options) {
  LogFiles files;
  files.folder_ = folder;
  files.stem_ = stem;
  files.compresses_ = options.compresses;
  files.disk_ = options.disk;
  const auto blog =
      std::make_shared<BlogWriter>(files.PathOf(".blog"), options.continues, *options.disk);
  const auto open_one = options.continues ? &AlogWriter::Continue : &AlogWriter::Open;
  const auto open = [&](bool is_wanted, const char* extension, std::optional<AlogWriter>& writer) {
    if (!is_wanted) {
      return std::optional<Error>();
    }
    Expected<AlogWriter> opened =
        open_one(files.PathOf(extension), start, options.lines, blog, *options.disk);
    if (!opened) {
      return std::optional<Error>(opened.error());
    }
    writer = *std::move(opened);
    return std::optional<Error>();
  };
  if (const auto failure = open(options.has_async, ".alog", files.async_)) return *failure;
  if (const auto failure = open(options.has_excluded, ".xlog", files.excluded_)) return *failure;
  if (const auto failure = open(options.has_system, ".ylog", files.system_)) return *failure;
  if (options.sync) {
    const fs::path file = options.continues ? files.NewSyncPath() : files.PathOf(".slog");
    auto opened = SlogWriter::Open(file, start, *options.sync, options.lines, *options.disk);
    if (!opened) {
      return opened.error();
    }
    files.sync_ = *std::move(opened);
  }
  return files;
}

fs::path LogFiles::PathOf(const char* extension) const { return folder_ / (stem_ + extension); }

fs::path LogFiles::NewSyncPath() const {
  fs::path file = PathOf(".slog");
  for (int number = 2; fs::exists(file); ++number) {
    // The former life may have left it with the system alone; nobody else brings it to the disk.
    if (Expected<AppendFile> former = AppendFile::Continue(file, *disk_)) {
      static_cast<void>(former->Sync());
    }
    file = folder_ / fmt::format("{}_{}.slog", stem_, number);
  }
  return file;
}

std::optional<AlogWriter>& LogFiles::WriterOf(LogLine::File file) {
  return file == LogLine::File::kAsync      ? async_
         : file == LogLine::File::kExcluded ? excluded_
                                            : system_;
}

void LogFiles::Put(const LogRecord& record) {
  std::visit(Overloaded{[this](const LogLine& line) {
                          if (auto& writer = WriterOf(line.file)) writer->Write(*line.message);
                        },
                        [this](const SyncRow& row) {
                          if (sync_) sync_->WriteRow(row.time, row.values);
                        },
                        [this](const ColumnClaim& claim) {
                          if (sync_) sync_->Claim(claim.name);
                        },
                        [this](const FileCopy& copy) { Keep(copy); },
                        [this](const LogComment& comment) {
                          if (async_) async_->WriteComment(comment.text);
                        }},
             record);
}

/// A copy that fails is noted in the log: it must not end the logging.
void LogFiles::Keep(const FileCopy& copy) {
  std::error_code failure;
  const std::string name = CopyName(copy);
  const bool is_file = fs::is_regular_file(copy.source, failure);
  const auto size = is_file ? fs::file_size(copy.source, failure) : 0;
  std::string problem = !is_file ? "no such file" : size > kMostBytesCopied ? "too big" : "";
  if (problem.empty()) {
    const Expected<std::string> bytes = ReadWhole(copy.source);
    const std::optional<Error> error =
        bytes ? WriteDurably(folder_ / name, *bytes, *disk_) : bytes.error();
    problem = error ? error->text : "";
  }
  if (!problem.empty() && async_) {
    async_->WriteComment(
        fmt::format("{} is not copied: {}", copy.source.filename().string(), problem));
  }
}

bool LogFiles::Flush() {
  bool is_good = true;  // every file has its chance, whatever became of the one before
  for (auto* writer : {&async_, &excluded_, &system_}) {
    is_good = (!*writer || (*writer)->Flush()) && is_good;
  }
  return (!sync_ || sync_->Flush()) && is_good;
}

bool LogFiles::Sync() {
  bool is_good = true;
  for (auto* writer : {&async_, &excluded_, &system_}) {
    is_good = (!*writer || (*writer)->Sync()) && is_good;
  }
  return (!sync_ || sync_->Sync()) && is_good;
}

bool LogFiles::Close() {
  bool is_good = Sync();
  const bool may_compress = compresses_ && is_good;
  for (const auto& [writer, extension] :
       {std::pair{&async_, ".alog"}, std::pair{&excluded_, ".xlog"}}) {
    if (may_compress && *writer) {
      writer->reset();
      is_good = CompressFile(PathOf(extension), *disk_) && is_good;
    }
  }
  return is_good;
}

std::error_code LogFiles::trouble() const {
  for (const auto* writer : {&async_, &excluded_, &system_}) {
    if (*writer && (*writer)->trouble()) {
      return (*writer)->trouble();
    }
  }
  return sync_ ? sync_->trouble() : std::error_code();
}

LogLosses LogFiles::losses() const {
  LogLosses losses;
  for (const auto* writer : {&async_, &excluded_, &system_}) {
    if (*writer) {
      losses += (*writer)->losses();
    }
  }
  if (sync_) {
    losses += sync_->losses();
  }
  return losses;
}

}  // namespace limpet
