// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/why_source.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limpet/console/community.hpp"
#include "limpet/core/config.hpp"
#include "limpet/log_tools/log_input.hpp"
#include "limpet/logbook/logs_below.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// The session of a log in a run folder: the first folder on the way.
std::string SessionOf(const fs::path& log, const fs::path& run) {
  const fs::path way = log.lexically_relative(run);
  return way.has_parent_path() ? way.begin()->string() : "";
}

struct RunLog {
  fs::path file;
  std::string session{};
};

/// The log of the session asked for, else of the one that began last. Throws UsageError.
RunLog LogIn(const fs::path& run, const std::optional<std::string>& session) {
  std::vector<fs::path> logs;
  std::vector<std::string> names;
  for (const fs::path& log : LogsBelow(run)) {
    names.push_back(SessionOf(log, run));
    if (!session || names.back() == *session) logs.push_back(log);
  }
  if (names.empty()) {
    throw UsageError(fmt::format("{}: holds no .alog file", run.string()));
  }
  if (logs.empty()) {
    const std::string nearest = NearestWord(*session, names);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    throw UsageError(fmt::format("{}: no session `{}`{}; sessions: {}", run.string(), *session,
                                 nearest.empty() ? "" : fmt::format("; nearest: `{}`", nearest),
                                 fmt::join(names, ", ")));
  }
  const fs::path latest = LatestLog(logs);
  return {.file = latest, .session = SessionOf(latest, run)};
}

WhySource FromLog(const std::string& word, const std::optional<std::string>& session) {
  const bool is_run = fs::is_directory(word);
  if (session && !is_run) {
    throw UsageError("--session is for run folders; this is a log");
  }
  const RunLog log = is_run ? LogIn(word, session) : RunLog{.file = word};
  LogInput input(log.file.string());
  WhySource source{.log = {}, .session = log.session, .place = log.file.string()};
  AlogLine line;
  AlogEntry entry;
  while (input.Next(line, entry)) {
    if (line.kind == AlogLine::Kind::kEntry) {
      source.log.Take({.variable = entry.name, .writer = entry.aux, .value = entry.value},
                      entry.time);
    }
  }
  input.PrintDoubts();
  return source;
}

WhySource FromCommunity(const Arguments& given, const std::string& mission) {
  const CommunityAddress address = AddressOf(given, mission);
  Community community(address, OwnName("uWhy"));
  community.Watch(topics::kHelmBids.name);
  community.Watch(topics::kHelmMotion.name);
  community.Watch(topics::kHelmState.name);
  community.Watch(topics::kHelmAllStop.name);
  auto mail = community.Settle();
  if (!mail) {
    throw std::runtime_error(
        fmt::format("{} did not answer within {:g} s", address.Text(), address.patience.value()));
  }
  std::ranges::stable_sort(*mail, {}, [](const auto& heard) { return heard.message.time; });
  WhySource source{.log = {}, .session = {}, .place = address.Text()};
  for (const auto& [message, heard] : *mail) {
    if (const auto* text = std::get_if<std::string>(&message.value)) {
      source.log.Take(message.name, *text, message.time.value());
    }
  }
  return source;
}

}  // namespace

WhySource WhySourceOf(const Arguments& given) {
  const std::string& word = given.positionals()[0];
  if (!IsMissionName(word)) {
    return FromLog(word, given.Find("session"));
  }
  for (const char* option : {"at", "from", "to", "changes", "session"}) {
    if (given.Has(option)) {
      throw UsageError(
          fmt::format("--{} needs a log: a live community knows its last decision only", option));
    }
  }
  return FromCommunity(given, word);
}

}  // namespace limpet
