// SPDX-License-Identifier: MIT
#include "apps/pLog/log_app.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

/// MOOS's stamp of a log folder, `21_11_2026_____07_20_00`: day and month without zeros. UTC.
std::string FolderStamp(Seconds utc) {
  const std::chrono::sys_seconds at{
      std::chrono::seconds{static_cast<std::int64_t>(std::max(utc.value(), 0.0))}};
  const auto midnight = std::chrono::floor<std::chrono::days>(at);
  const std::chrono::year_month_day date{midnight};
  const std::chrono::hh_mm_ss clock{at - midnight};
  return fmt::format("{}_{}_{}_____{:02}_{:02}_{:02}", static_cast<unsigned>(date.day()),
                     static_cast<unsigned>(date.month()), static_cast<int>(date.year()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count());
}

/// Patterns may stand several to a line, separated by commas.
bool MatchesAny(const std::vector<std::string>& lines, std::string_view name) {
  return std::ranges::any_of(lines, [name](const std::string& line) {
    return std::ranges::any_of(Split(line, ','), [name](const std::string& pattern) {
      return MatchesWildcard(Trim(pattern), name);
    });
  });
}

}  // namespace

LogApp::LogApp(const AppContext& context, const Params& params)
    : App(context), params_(params), start_(now()) {
  ReadRates();
  if (!params_.async_log) {
    return;
  }
  if (params_.wildcard_logging) {
    SubscribeRaw(WildcardFilter{}, [this](const MessagePtr& message) { OnMail(message); });
  } else {
    for (const auto& [name, rate] : rates_) {
      SubscribeRaw(name, [this](const MessagePtr& message) { OnMail(message); });
    }
  }
}

void LogApp::ReadRates() {
  std::vector<ConfigProblem> problems;
  for (const std::string& line : params_.logged) {
    const std::string_view text = std::string_view(line).substr(0, line.find(','));  // NOSYNC, ...
    const std::size_t at = text.find('@');
    const std::string name(Trim(text.substr(0, at)));
    const std::optional<double> interval = at == std::string_view::npos
                                               ? std::optional<double>(0.0)
                                               : ParseNumber(text.substr(at + 1));
    if (name.empty() || !interval || *interval < 0.0) {
      problems.push_back({{}, "Log", fmt::format("`{}` is not VARIABLE @ seconds", line)});
    } else {
      rates_[name] = {.interval = Seconds(*interval), .last = std::nullopt};
    }
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
}

bool LogApp::Wants(const Message& message) {
  if (std::holds_alternative<Binary>(message.value) && !params_.logs_binaries) {
    return false;
  }
  if (const auto rate = rates_.find(message.name); rate != rates_.end()) {
    const bool is_due =
        !rate->second.last || message.time - *rate->second.last >= rate->second.interval;
    rate->second.last = is_due ? message.time : *rate->second.last;
    return is_due;
  }
  const auto [verdict, is_new] = matches_.try_emplace(message.name, false);
  if (is_new) {
    verdict->second = MatchesAny(params_.wildcard_patterns, message.name) &&
                      !MatchesAny(params_.wildcard_omit_patterns, message.name);
  }
  return verdict->second;
}

void LogApp::OnMail(const MessagePtr& message) {
  if (!Wants(*message)) {
    return;
  }
  OpenIfNeeded();
  if (writer_) {
    writer_->Write(*message);
  }
}

std::filesystem::path LogApp::FilePath() const {
  if (!context().run_folder.empty()) {
    return context().run_folder /
           ((context().session.empty() ? "log" : context().session) + ".alog");
  }
  const std::string stem =
      params_.has_time_stamp ? params_.file + "_" + FolderStamp(start_) : params_.file;
  const std::filesystem::path parent =
      params_.path.empty() ? context().Global("GlobalLogPath") : params_.path;
  return parent / stem / (stem + ".alog");
}

void LogApp::OpenIfNeeded() {
  if (writer_ || has_failed_) {
    return;
  }
  const std::filesystem::path file = FilePath();
  std::error_code ignored;  // a missing folder shows when the file cannot be created
  std::filesystem::create_directories(file.parent_path(), ignored);
  Expected<AlogWriter> writer =
      AlogWriter::Open(file, start_,
                       {.double_precision = params_.double_precision,
                        .has_source_aux = params_.has_aux,
                        .marks_data_type = params_.marks_data_type,
                        .marks_other_communities = params_.marks_communities,
                        .community = context().Global("Community")});
  if (!writer) {
    has_failed_ = true;
    Warn("LOG_FAILED", writer.error().text);
    return;
  }
  writer_ = *std::move(writer);
}

void LogApp::Save() {
  if (!writer_) {
    return;
  }
  const bool is_embedded = !context().run_folder.empty();
  if (is_embedded ? !writer_->Flush() : !writer_->Sync()) {
    Warn("LOG_FAILED", "the log cannot be written; is the disk full?");
  }
}

void LogApp::Tick(Seconds) { Save(); }

void LogApp::Finish(Seconds) { Save(); }

LIMPET_REGISTER_APP(LogApp, "pLog", 1.0);

}  // namespace limpet
