// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_reader.hpp"

#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/logbook/alog_escape.hpp"

namespace limpet {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;
constexpr std::string_view kBlanks = " \t";

/// Takes the next word and the blanks around it off `text`.
std::string_view TakeWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

std::optional<double> NumberOf(std::string_view text) {
  // Most values that are no numbers show it at once; that saves the parse.
  if (text.empty() || text.size() > 400 || (text[0] > '9' || text[0] < '+')) {
    return std::nullopt;
  }
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data() + (text[0] == '+' ? 1 : 0), end, value);
  const bool is_number = result.ec == std::errc{} && result.ptr == end && std::isfinite(value);
  return is_number ? std::optional<double>(value) : std::nullopt;
}

}  // namespace

Expected<AlogReader> AlogReader::Open(const std::filesystem::path& file) {
  AlogReader reader;
  reader.file_.reset(std::fopen(file.c_str(), "rb"));
  std::error_code ignored;
  if (!reader.file_ || std::filesystem::is_directory(file, ignored)) {
    return Error{fmt::format("`{}` cannot be read", file.string())};
  }
  return reader;
}

AlogReader AlogReader::OfText(std::string_view text) {
  AlogReader reader;
  reader.pending_ = text;
  return reader;
}

bool AlogReader::Refill() {
  if (!file_) {
    return false;
  }
  // What is left of the last chunk moves to the front, and the buffer grows for very long lines.
  buffer_.erase(0, buffer_.size() - pending_.size());
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + kChunkBytes);
  const std::size_t count = std::fread(buffer_.data() + kept, 1, kChunkBytes, file_.get());
  buffer_.resize(kept + count);
  pending_ = buffer_;
  return count > 0;
}

bool AlogReader::NextLine(std::string_view& line) {
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = pending_.find('\n', searched);
    if (end != std::string_view::npos) {
      line = pending_.substr(0, end);
      pending_.remove_prefix(end + 1);
      return true;
    }
    searched = pending_.size();
    if (!Refill()) {
      has_torn_end_ = !pending_.empty();
      pending_ = {};
      return false;
    }
  }
}

bool AlogReader::Next(AlogEntry& entry) {
  std::string_view line;
  while (NextLine(line)) {
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    if (line.starts_with('%')) {
      ReadComment(line);
    } else if (ReadEntry(line, entry)) {
      return true;
    } else if (!line.empty()) {
      ++skipped_;
    }
  }
  return false;
}

void AlogReader::ReadComment(std::string_view line) {
  constexpr std::string_view kStart = "LOGSTART";
  if (const std::size_t at = line.find(kStart); at != std::string_view::npos && !start_) {
    if (const auto start = ParseNumber(line.substr(at + kStart.size()))) {
      start_ = Seconds(*start);
    }
  }
  has_escapes_ = has_escapes_ || line == kAlogEscapeNotice;
  has_type_marks_ = has_type_marks_ || line.find("DATATYPE MARKING ON") != std::string_view::npos;
}

bool AlogReader::ReadEntry(std::string_view line, AlogEntry& entry) {
  const std::optional<double> time = NumberOf(TakeWord(line));
  entry.name = TakeWord(line);
  entry.source = TakeWord(line);
  if (!time || entry.source.empty()) {
    return false;
  }
  entry.time = *time;
  const std::size_t colon = entry.source.find(':');
  const bool has_aux = colon != std::string_view::npos && colon > 0;
  entry.aux = has_aux ? entry.source.substr(colon + 1) : std::string_view{};
  entry.source = entry.source.substr(0, has_aux ? colon : std::string_view::npos);
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  if (line.ends_with(' ')) {
    line.remove_suffix(1);
  }
  ReadValue(line, entry);
  // An empty string is a value in our logs; MOOS's tools drop such a line.
  return has_escapes_ || !entry.value.empty();
}

void AlogReader::ReadValue(std::string_view text, AlogEntry& entry) {
  const bool is_marked_string = has_type_marks_ && text.starts_with("S:");
  const bool is_marked_number = has_type_marks_ && text.starts_with("D:");
  text.remove_prefix(is_marked_string || is_marked_number ? 2 : 0);
  const std::string_view bare = text.substr(0, text.find_last_not_of(kBlanks) + 1);
  entry.number = is_marked_string ? std::nullopt : NumberOf(bare);
  entry.value = entry.number ? bare : text;
  if (has_escapes_ && text.find('\\') != std::string_view::npos) {
    unescaped_.clear();
    AppendUnescaped(unescaped_, text);
    entry.value = unescaped_;
  }
}

std::optional<BlogSpan> ParseBlogMarker(std::string_view value) {
  constexpr std::string_view kOpen = "<MOOS_BINARY>";
  constexpr std::string_view kClose = "</MOOS_BINARY>";
  value = Trim(value);
  if (!value.starts_with(kOpen) || !value.ends_with(kClose) ||
      value.size() < kOpen.size() + kClose.size()) {
    return std::nullopt;
  }
  BlogSpan span;
  for (const std::string& part :
       Split(value.substr(kOpen.size(), value.size() - kOpen.size() - kClose.size()), ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view key = std::string_view(part).substr(0, equals);
    const std::string_view text =
        std::string_view(part).substr(equals == std::string::npos ? part.size() : equals + 1);
    const std::optional<std::int64_t> number = ParseInteger(text);
    const bool is_count = number && *number >= 0;
    if (key == "File" && !text.empty()) {
      span.file = std::string(text);
    } else if (key == "Offset" && is_count) {
      span.offset = static_cast<std::size_t>(*number);
    } else if (key == "Bytes" && is_count) {
      span.bytes = static_cast<std::size_t>(*number);
    } else {
      return std::nullopt;
    }
  }
  return span.file.empty() ? std::nullopt : std::optional<BlogSpan>(span);
}

Expected<Binary> ReadBlog(const std::filesystem::path& folder, const BlogSpan& span) {
  // Only the file name counts: a log must not lead to files elsewhere.
  const std::filesystem::path path = folder / std::filesystem::path(span.file).filename();
  std::error_code failure;
  const auto size = std::filesystem::file_size(path, failure);
  if (failure || span.offset > size || span.bytes > size - span.offset) {
    return Error{
        fmt::format("`{}` does not hold {} bytes at {}", path.string(), span.bytes, span.offset)};
  }
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(span.offset));
  Binary bytes(span.bytes);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(span.bytes));
  return in ? Expected<Binary>(std::move(bytes))
            : Expected<Binary>(Error{fmt::format("`{}` cannot be read", path.string())});
}

}  // namespace limpet
