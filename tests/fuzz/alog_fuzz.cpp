// SPDX-License-Identifier: MIT
// Any bytes as a log: the reader must come to its end, and agree with itself however they are cut.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/alog_recovery.hpp"
#include "limpet/logbook/alog_statistics.hpp"

namespace {

std::uint64_t EntriesIn(std::string_view text) {
  limpet::AlogReader reader = limpet::AlogReader::OfText(text);
  limpet::AlogStatistics statistics;
  limpet::AlogRecovery recovery("/nonexistent");
  limpet::AlogLine line;
  for (limpet::AlogEntry entry; reader.NextLine(line, entry);) {
    statistics.Add(line, entry);
    static_cast<void>(recovery.Keeps(line, entry));
  }
  return statistics.entries();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::uint64_t all = EntriesIn(text);
  // A tear loses no complete line before it.
  const std::size_t end = text.rfind('\n', size / 2);
  const std::string_view sound = text.substr(0, end == std::string_view::npos ? 0 : end + 1);
  const std::uint64_t before = EntriesIn(text.substr(0, std::max(size / 2, sound.size())));
  if (before != EntriesIn(sound) || before > all) {
    std::abort();
  }
  return 0;
}
