// SPDX-License-Identifier: MIT
#include "limpet/logbook/logs_below.hpp"

#include <algorithm>

#include "limpet/core/require.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/log_name.hpp"

namespace limpet {

namespace fs = std::filesystem;

std::vector<fs::path> LogsBelow(const fs::path& folder) {
  std::vector<fs::path> logs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && IsAlogName(entry.path())) logs.push_back(entry.path());
  }
  std::ranges::sort(logs);
  return logs;
}

Seconds StartOfLog(const fs::path& log) {
  auto reader = AlogReader::Open(log);
  if (!reader) return Seconds(0.0);
  AlogLine line;
  AlogEntry entry;
  while (reader->NextLine(line, entry) && line.kind != AlogLine::Kind::kEntry) {
  }
  return reader->start().value_or(Seconds(0.0));
}

fs::path LatestLog(const std::vector<fs::path>& logs) {
  LIMPET_REQUIRE(!logs.empty(), "no log to choose from");
  return *std::ranges::max_element(logs, {}, StartOfLog);
}

}  // namespace limpet
