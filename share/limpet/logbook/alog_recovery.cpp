// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_recovery.hpp"

#include <algorithm>

namespace limpet {
namespace {

/// No control characters: what a torn block or a binary in the wrong place would bring.
bool IsText(std::string_view line) {
  return std::ranges::all_of(line, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20U ? byte != 0x7fU : c == '\t';
  });
}

}  // namespace

bool AlogRecovery::HasBytes(const BlogSpan& span) {
  const std::filesystem::path path = BlogPath(folder_, span);
  const auto [found, is_new] = blogs_.try_emplace(path.filename().string());
  if (is_new) {
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::file_size(path, failure);
    found->second = failure ? std::nullopt : std::optional<std::uintmax_t>(size);
  }
  const std::optional<std::uintmax_t>& size = found->second;
  return size && span.offset <= *size && span.bytes <= *size - span.offset;
}

bool AlogRecovery::Keeps(const AlogLine& line, const AlogEntry& entry) {
  switch (line.kind) {
    case AlogLine::Kind::kBlank:
      return true;
    case AlogLine::Kind::kComment:
    case AlogLine::Kind::kBroken: {
      const bool is_text = IsText(line.text);
      damaged_lines_ += is_text ? 0 : 1;
      other_lines_ += is_text && line.kind == AlogLine::Kind::kBroken ? 1 : 0;
      return is_text;
    }
    case AlogLine::Kind::kEntry:
      break;
  }
  if (entry.value.starts_with("<MOOS_BINARY>")) {
    const std::optional<BlogSpan> span = ParseBlogMarker(entry.value);
    if (span && !HasBytes(*span)) {
      ++lost_binaries_;
      return false;
    }
  }
  ++entries_;
  return true;
}

}  // namespace limpet
