// SPDX-License-Identifier: MIT
#include "apps/pLog/log_memory.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/logbook/alog_reader.hpp"

namespace limpet {

namespace fs = std::filesystem;

void KeepLog(const LogMemory& memory, const fs::path& file, FileSystem& disk) {
  static_cast<void>(
      WriteDurably(file,
                   fmt::format("{}\n{}\n{:.17g}\n", fs::absolute(memory.folder).string(),
                               memory.stem, memory.start.value()),
                   disk));
}

std::optional<LogMemory> RecallLog(const fs::path& file) {
  std::ifstream in(file);
  std::string folder, stem, start;
  if (!std::getline(in, folder) || !std::getline(in, stem) || !std::getline(in, start)) {
    return std::nullopt;
  }
  const std::optional<double> number = ParseNumber(start);
  LogMemory memory{.folder = folder, .stem = stem, .start = Seconds(number.value_or(0.0))};
  return number && fs::is_regular_file(memory.log()) ? std::optional(memory) : std::nullopt;
}

std::optional<double> LatestTimeIn(const fs::path& log) {
  constexpr std::uintmax_t kTail = 256 * 1024;
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(log, failure);
  if (failure) {
    return std::nullopt;
  }
  std::ifstream in(log, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(size - std::min(size, kTail)));
  const std::string tail{std::istreambuf_iterator<char>(in), {}};
  // The cut first line may look like an entry of another time.
  const std::size_t begin = size > kTail ? std::min(tail.find('\n'), tail.size() - 1) + 1 : 0;
  AlogReader reader = AlogReader::OfText(std::string_view(tail).substr(begin));
  std::optional<double> latest;
  for (AlogEntry entry; reader.Next(entry);) {
    latest = std::max(latest.value_or(entry.time), entry.time);
  }
  return latest;
}

}  // namespace limpet
