// SPDX-License-Identifier: MIT
#include "limpet/scoring/log_replay.hpp"

#include <algorithm>
#include <vector>

#include "limpet/logbook/alog_reader.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// MOOS time at which a log begins.
double StartOf(const fs::path& log) {
  auto reader = AlogReader::Open(log);
  if (!reader) return 0.0;
  AlogLine line;
  AlogEntry entry;
  while (reader->NextLine(line, entry) && line.kind != AlogLine::Kind::kEntry) {
  }
  return reader->start().value_or(Seconds(0.0)).value();
}

/// `<session>.alog`, else the one that began last: a folder may hold several runs.
std::optional<fs::path> LogIn(const fs::path& folder) {
  const fs::path expected = folder / (folder.filename().string() + ".alog");
  if (fs::exists(expected)) return expected;
  std::vector<fs::path> logs;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".alog") logs.push_back(entry.path());
    }
  }
  if (logs.empty()) return std::nullopt;
  return *std::ranges::max_element(logs, {}, StartOf);
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
