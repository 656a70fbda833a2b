// SPDX-License-Identifier: MIT
// Where pLog's files are and how they come about.
#include <fmt/format.h>

#include "apps/pLog/log_app.hpp"
#include "apps/pLog/log_warnings.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/logbook/log_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr Seconds kRetryTime{10.0};  ///< after a log could not be opened

/// MOOS time is UNIX time times warp; virtual time knows no warp.
double WarpOf(const AppContext& context) {
  const double warp = ParseNumber(context.Global("MOOSTimeWarp")).value_or(1.0);
  return context.runs_live && warp > 0.0 ? warp : 1.0;
}

}  // namespace

fs::path LogApp::MemoryFile() const {
  const bool is_kept = context().runs_live && !context().run_folder.empty();
  return is_kept ? context().run_folder / (context().name + ".session") : fs::path();
}

LogFilesOptions LogApp::FileOptions() const {
  LogFilesOptions options{.lines = {.double_precision = params_.double_precision,
                                    .has_source_aux = params_.has_aux,
                                    .marks_data_type = params_.marks_data_type,
                                    .marks_other_communities = params_.marks_communities,
                                    .community = context().Global("Community"),
                                    .time_warp = WarpOf(context())},
                          .has_async = params_.async_log,
                          .has_excluded = params_.has_exclusion_log,
                          .has_system = context().runs_live,
                          .sync = std::nullopt,
                          .compresses = params_.compresses && context().runs_live,
                          .disk = context().disk};
  if (sync_period_) {
    options.sync = {.names = sync_names_, .spare = spare_columns_};
  }
  return options;
}

Expected<fs::path> LogApp::CreateFolder() {
  if (!context().runs_live) {
    if (const auto failure = CreateFolders(context().run_folder, *context().disk)) {
      return *failure;
    }
    return context().run_folder;
  }
  const Seconds utc(start_.value() / WarpOf(context()));
  const std::string stem = params_.has_time_stamp
                               ? params_.file + "_" + LogFolderStamp(utc, !params_.uses_utc)
                               : params_.file;
  const std::string global = context().Global("GlobalLogPath");
  const fs::path parent = !global.empty()         ? fs::path(global)
                          : !params_.path.empty() ? fs::path(params_.path)
                                                  : context().run_folder;
  Expected<fs::path> folder = CreateLogFolder(parent.empty() ? "." : parent, stem, *context().disk);
  if (folder) {
    ClearWarning(warnings::kLogFolder);
    return folder;
  }
  // As MOOS's logger does: a log in the wrong place is better than none.
  Warn(warnings::kLogFolder, folder.error().text + "; logging to the working directory");
  return CreateLogFolder(".", stem, *context().disk);
}

void LogApp::OpenIfNeeded() {
  const bool is_early = failed_at_ && now() - *failed_at_ < kRetryTime;
  if (session_.is_open() || is_early || is_over_) {
    return;
  }
  failed_at_.reset();
  if (const auto failure = Open()) {
    failed_at_ = now();
    failure_ = failure->text;
    TellState(failure_);
  } else if (unlogged_ > 0) {
    session_.Put(LogComment{fmt::format("{} messages before this could not be logged", unlogged_)});
  }
}

std::optional<Error> LogApp::Open() {
  LogFilesOptions options = FileOptions();
  options.continues = former_.has_value();
  const Expected<fs::path> folder = former_ ? former_->folder : CreateFolder();
  if (!folder) {
    return folder.error();
  }
  const std::string session = context().session.empty() ? "log" : context().session;
  const std::string stem = former_               ? former_->stem
                           : context().runs_live ? folder->filename().string()
                                                 : session;
  if (auto failure = session_.Open(*folder, stem, start_, options)) {
    if (context().runs_live && !former_) {
      RemoveFolder(*folder, *context().disk);  // it is tried again, in another one
    }
    return failure;
  }
  former_.reset();
  if (const fs::path memory = MemoryFile(); !memory.empty()) {
    KeepLog({.folder = *folder, .stem = stem, .start = start_}, memory, *context().disk);
  }
  if (context().runs_live) {
    AnnounceFolder(*folder);
  }
  return std::nullopt;
}

/// What MOOS's logger does at the start of a session.
void LogApp::AnnounceFolder(const fs::path& folder) {
  folder_ = folder.string();
  PublishRaw("LOGGER_DIRECTORY", folder_);
  if (!params_.summary_file.empty()) {
    // A convenience: without it the folder is still announced.
    static_cast<void>(WriteDurably(
        params_.summary_file, "LastOpenedLoggingDirectory=" + folder_ + "\n", *context().disk));
  }
  if (!context().mission_file.empty()) {
    Put(FileCopy{.source = context().mission_file, .stem = folder.filename().string()});
  }
}

}  // namespace limpet
