// SPDX-License-Identifier: MIT
#include "apps/pLog/log_app.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "apps/pLog/log_warnings.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/wire/message_id.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr Seconds kMonitorTime{10.0};       ///< longest silence of a monitored variable
constexpr int kMostCopies = 64;             ///< at request, in one session of logging
constexpr Seconds kRefusalTime{60.0};       ///< that a refused copy is warned of
constexpr Seconds kAnnouncementTime{10.0};  ///< between repeats of LOGGER_DIRECTORY

bool IsSystemMessage(std::string_view name) {
  return name == "MOOS_DEBUG" || name == "MOOS_SYSTEM";
}

}  // namespace

LogApp::LogApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      start_(now()),
      choice_({.is_used = params.wildcard_logging,
               .wanted = params.wildcard_patterns,
               .omitted = params.wildcard_omit_patterns,
               .has_exclusion_log = params.has_exclusion_log}),
      spare_columns_(params.spare_columns),
      session_(context.runs_live),
      last_announcement_(start_) {
  if (context.is_restarted && context.runs_live) {
    former_ = RecallLog(MemoryFile());
  }
  if (former_) {
    start_ = former_->start;
    if (const auto latest = LatestTimeIn(former_->log())) {
      logged_until_ = start_ + Seconds(*latest);
    }
  }
  ReadParams();
  SubscribeToAll();
}

void LogApp::ReadParams() {
  std::vector<ConfigProblem> problems;
  for (const std::string& line : params_.logged) {
    const Expected<LogRequest> request = ParseLogRequest(line);
    if (!request) {
      problems.push_back({{}, "Log", request.error().text});
      continue;
    }
    if (choice_.Add(*request) && request->is_synced) {
      sync_names_.push_back(request->name);
    }
    if (request->is_monitored) {
      monitored_[request->name] = start_;
    }
  }
  const bool is_live = EqualsIgnoringCase(params_.logs_binaries, "live");
  const std::optional<bool> flag = ParseFlag(params_.logs_binaries);
  logs_binaries_ = is_live ? context().runs_live : flag.value_or(false);
  if (!is_live && !flag) {
    problems.push_back({{}, "LogBinary", "is not true, false or live"});
  }
  if (const auto period = ParseSyncLog(params_.sync_log)) {
    sync_period_ = *period;
  } else {
    problems.push_back({{}, "SyncLog", period.error().text});
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
}

void LogApp::SubscribeToAll() {
  const bool has_async = params_.async_log || params_.has_exclusion_log;
  if (sync_period_) {
    table_.emplace(sync_names_, *sync_period_);
  }
  const auto on_mail = [this](const MessagePtr& message) { OnMail(message); };
  if (context().runs_live) {
    for (const char* command : {"PLOGGER_CMD", "PLOG_CMD", "LOGGER_RESTART"}) {
      SubscribeRaw(command, [this](const MessagePtr& message) { OnCommand(message); });
    }
  }
  if (params_.wildcard_logging && has_async) {
    SubscribeRaw(WildcardFilter{}, on_mail);
    return;
  }
  if (has_async || table_) {
    for (const std::string& name : choice_.Requested()) {
      SubscribeRaw(name, on_mail);
    }
  }
  if (context().runs_live) {
    SubscribeRaw("MOOS_DEBUG", on_mail);
    SubscribeRaw("MOOS_SYSTEM", on_mail);
  }
}

void LogApp::OnMail(const MessagePtr& message) {
  if (logged_until_ && message->id == message_id::kLatest && message->time <= *logged_until_) {
    return;
  }
  const bool is_left_out = std::holds_alternative<Binary>(message->value) && !logs_binaries_;
  const auto file = is_left_out ? std::nullopt : choice_.FileFor(*message);
  if (file) {
    ++messages_;
    binaries_ += std::holds_alternative<Binary>(message->value) ? 1 : 0;
    Put(LogLine{*file, message});
  }
  if (context().runs_live && IsSystemMessage(message->name)) {
    Put(LogLine{LogLine::File::kSystem, message});
  }
  if (const auto found = monitored_.find(message->name); found != monitored_.end()) {
    found->second = now();
    ClearWarning(warnings::kSilent, message->name);
  }
  PutDueRow();
  if (table_) {
    table_->Update(*message);
  }
}

void LogApp::OnCommand(const MessagePtr& message) {
  if (message->name == "LOGGER_RESTART") {
    Restart();
    return;
  }
  const auto* text = std::get_if<std::string>(&message->value);
  const std::string_view command = text == nullptr ? std::string_view() : Trim(*text);
  const std::size_t equals = std::min(command.find('='), command.size());
  const std::string_view task = Trim(command.substr(0, equals));
  const std::string_view argument = Trim(command.substr(std::min(equals + 1, command.size())));
  if (EqualsIgnoringCase(task, "COPY_FILE_REQUEST") && !argument.empty()) {
    OnCopyRequest(argument, message->source);
  } else if (EqualsIgnoringCase(task, "LOG_REQUEST")) {
    OnLogRequest(argument);
  } else {
    Warn(warnings::kBadCommand,
         fmt::format("`{}` is no LOG_REQUEST or COPY_FILE_REQUEST", command));
  }
}

/// Any client may ask: so only what belongs to the mission or to this run is copied.
void LogApp::OnCopyRequest(std::string_view name, std::string_view asker) {
  const Expected<fs::path> file = CopyableFile(name);
  if (file) {
    ++copies_;
    ClearWarning(warnings::kBadCommand);
    Put(FileCopy{.source = *file, .stem = ""});
    return;
  }
  ++refused_copies_;
  Put(LogComment{
      fmt::format("{} is not copied: {}", fs::path(name).filename().string(), file.error().text)});
  last_refusal_ = now();
  Warn(warnings::kCopyRefused,
       fmt::format("COPY_FILE_REQUEST of `{}`, by {}: {}; the report counts them",
                   name.substr(0, 200), asker, file.error().text));
}

Expected<fs::path> LogApp::CopyableFile(std::string_view name) const {
  std::error_code failure;
  fs::path asked(name);
  if (const fs::path beside = context().mission_file.parent_path() / asked;
      asked.is_relative() && fs::exists(beside, failure)) {
    asked = beside;  // so helms ask for their behavior files
  }
  const fs::path real = fs::canonical(asked, failure);
  if (failure || !fs::is_regular_file(real, failure)) {
    return Error{"no such file"};
  }
  if (copies_ >= kMostCopies) {
    return Error{fmt::format("more than {} copies in a session", kMostCopies)};
  }
  std::vector<fs::path> folders;
  if (!context().mission_file.empty()) {
    folders.push_back(fs::absolute(context().mission_file).parent_path());
  }
  if (!context().run_folder.empty()) {
    folders.push_back(context().run_folder);
  }
  for (const fs::path& folder : folders) {
    const fs::path relative = real.lexically_relative(fs::weakly_canonical(folder));
    const bool is_hidden = std::ranges::any_of(
        relative, [](const fs::path& part) { return part.string().starts_with('.'); });
    if (!relative.empty() && !is_hidden) {  // `..` begins with a dot too
      return real;
    }
  }
  return Error{"not a visible file of the mission's folder or the run folder"};
}

void LogApp::OnLogRequest(std::string_view line) {
  const Expected<LogRequest> request = ParseLogRequest(line);
  if (!request) {
    Warn(warnings::kBadCommand, request.error().text);
    return;
  }
  ClearWarning(warnings::kBadCommand);
  if (!choice_.Add(*request)) {
    return;
  }
  if (table_ && request->is_synced && spare_columns_ > 0) {
    --spare_columns_;
    sync_names_.push_back(request->name);
    table_->AddColumn(request->name);
    if (session_.is_open()) {
      Put(ColumnClaim{request->name});
    }
  }
  if (!params_.wildcard_logging) {
    SubscribeRaw(request->name, [this](const MessagePtr& message) { OnMail(message); });
  }
}

void LogApp::Restart() {
  session_.Close();
  ClearWarning(warnings::kLogDropped);
  failed_at_.reset();
  unlogged_ = 0;
  copies_ = 0;
  start_ = now();
  if (sync_period_) {
    table_.emplace(sync_names_, *sync_period_);
  }
  OpenIfNeeded();
}

void LogApp::Put(LogRecord record) {
  OpenIfNeeded();
  if (session_.is_open()) {
    session_.Put(std::move(record));  // it counts what it drops
  } else if (std::holds_alternative<LogLine>(record)) {
    ++unlogged_;
  }
}

void LogApp::PutDueRow() {
  if (table_) {
    if (std::optional<SyncRow> row = table_->TakeDueRow(now() - start_)) {
      Put(*std::move(row));
    }
  }
}

void LogApp::WatchMonitored(Seconds now) {
  for (const auto& [name, heard] : monitored_) {
    if (now - heard > kMonitorTime) {
      Warn(warnings::kSilent.Of(name), name + " is to be logged but does not appear");
    }
  }
}

void LogApp::Tick(Seconds now) {
  PutDueRow();
  WatchMonitored(now);
  if (last_refusal_ && now - *last_refusal_ > kRefusalTime) {
    ClearWarning(warnings::kCopyRefused);
  }
  if (context().runs_live) {
    OpenIfNeeded();
    if (session_.is_open() && now - last_announcement_ >= kAnnouncementTime) {
      last_announcement_ = now;
      PublishRaw("LOGGER_DIRECTORY", folder_);
    }
  }
  Save();
}

/// Apps that end later may still write; embedded, the destructor saves that.
void LogApp::Finish(Seconds) {
  PutDueRow();
  Save();
  is_over_ = context().runs_live;
  if (is_over_) {
    session_.Close();
  }
}

LIMPET_REGISTER_APP(LogApp, "pLog", 1.0);

}  // namespace limpet
