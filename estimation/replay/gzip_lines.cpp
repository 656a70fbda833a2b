// SPDX-License-Identifier: MIT
#include <cstring>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <zlib.h>

#include "estimation/replay/sensor_stream.hpp"

namespace limpet {

Expected<StreamFile> ReadLines(const std::filesystem::path& file) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> input(gzopen(file.c_str(), "rb"), gzclose);
  if (input == nullptr) {
    return Error{fmt::format("{}: cannot be opened", file.string())};
  }
  StreamFile read{.name = file.string(), .lines = {}, .damage = {}};
  std::vector<std::string>& lines = read.lines;
  std::string pending;
  std::array<char, 65536> buffer{};
  int count = 0;
  while ((count = gzread(input.get(), buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
    const char* at = buffer.data();
    const char* end = at + count;
    while (at < end) {
      const auto* newline =
          static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
      if (newline == nullptr) {
        pending.append(at, end);
        break;
      }
      pending.append(at, newline);
      lines.push_back(std::move(pending));
      pending.clear();
      at = newline + 1;
    }
  }
  int code = Z_OK;
  const char* why = gzerror(input.get(), &code);
  if (code != Z_OK && code != Z_STREAM_END) {
    read.damage = fmt::format("{}:{}: the file is damaged or cut short ({})", read.name,
                              lines.size() + 1, why);
  } else if (!pending.empty()) {
    read.is_last_line_whole = false;
    lines.push_back(std::move(pending));
  }
  return read;
}

}  // namespace limpet
