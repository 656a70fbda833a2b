// SPDX-License-Identifier: MIT
#include "limpet/scoring/log_replay.hpp"

#include <optional>
#include <vector>

#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/logs_below.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// `<session>.alog`, else the one that began last: a folder may hold several runs.
std::optional<fs::path> LogIn(const fs::path& folder) {
  const fs::path expected = folder / (folder.filename().string() + ".alog");
  if (fs::exists(expected)) return expected;
  if (!fs::is_directory(folder)) return std::nullopt;
  const std::vector<fs::path> logs = LogsBelow(folder);
  return logs.empty() ? std::nullopt : std::optional(LatestLog(logs));
}

/// Text, number or, for what lies in the .blog file, bytes. Nothing if those cannot be read.
std::optional<Value> ValueOf(const AlogEntry& entry, const fs::path& folder) {
  if (entry.number) return Value(*entry.number);
  if (const auto span = ParseBlogMarker(entry.value)) {
    auto bytes = ReadBlog(folder, *span);
    if (!bytes) return std::nullopt;
    return Value(*std::move(bytes));
  }
  return Value(std::string(entry.value));
}

}  // namespace

Expected<SessionRecord> RecordFromLog(const fs::path& session_folder) {
  const auto path = LogIn(session_folder);
  if (!path) return Error{"no .alog file in " + session_folder.string()};
  auto reader = AlogReader::Open(*path);
  if (!reader) return reader.error();
  AlogReader log = *std::move(reader);
  SessionRecord record(session_folder.filename().string());
  AlogEntry entry;
  Message message;
  while (log.Next(entry)) {
    message.name = std::string(entry.name);
    if (!SessionRecord::Listens(message.name)) continue;
    auto value = ValueOf(entry, path->parent_path());
    if (!value) continue;
    message.value = *std::move(value);
    message.source = std::string(entry.source);
    message.time = Seconds(log.start().value_or(Seconds(0.0)).value() + entry.time);
    record.Collect(message);
  }
  return record;
}

}  // namespace limpet
