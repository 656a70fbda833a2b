// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_reader.hpp"

#include <charconv>
#include <cmath>

#include "limpet/core/number_text.hpp"
#include "limpet/logbook/alog_escape.hpp"

namespace limpet {
namespace {

constexpr std::size_t kReadBytes = std::size_t{1} << 20U;
constexpr std::size_t kMostLineBytes = std::size_t{128} << 20U;
constexpr std::size_t kMostExamples = 3;

bool IsBlank(char c) { return c == ' ' || c == '\t'; }

void SkipBlanks(std::string_view& text) {
  std::size_t count = 0;
  while (count < text.size() && IsBlank(text[count])) {
    ++count;
  }
  text.remove_prefix(count);
}

/// Takes the next word and the blanks before it off `text`.
std::string_view TakeWord(std::string_view& text) {
  SkipBlanks(text);
  std::size_t length = 0;
  while (length < text.size() && !IsBlank(text[length])) {
    ++length;
  }
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

std::string_view WithoutTrailingBlanks(std::string_view text) {
  while (!text.empty() && IsBlank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
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
  Expected<SequentialFile> opened = SequentialFile::Open(file);
  if (!opened) {
    return opened.error();
  }
  AlogReader reader;
  reader.file_ = *std::move(opened);
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
  buffer_.resize(kept + kReadBytes);
  const std::size_t count = file_->Read(buffer_.data() + kept, kReadBytes);
  buffer_.resize(kept + count);
  pending_ = buffer_;
  return count > 0;
}

bool AlogReader::TakeLine(std::string_view& line) {
  std::size_t searched = 0;
  is_too_long_ = false;
  while (true) {
    const std::size_t end = pending_.find('\n', searched);
    if (end != std::string_view::npos) {
      line = pending_.substr(0, end);
      pending_.remove_prefix(end + 1);
      return true;
    }
    if (file_ && pending_.size() > kMostLineBytes) {
      pending_ = {};
      is_too_long_ = true;
    }
    searched = pending_.size();
    if (!Refill()) {
      has_torn_end_ = !pending_.empty() || is_too_long_;
      pending_ = {};
      return false;
    }
  }
}

bool AlogReader::Next(AlogEntry& entry) {
  for (AlogLine line; NextLine(line, entry);) {
    if (line.kind == AlogLine::Kind::kEntry) {
      return true;
    }
  }
  return false;
}

bool AlogReader::NextLine(AlogLine& line, AlogEntry& entry) {
  if (!TakeLine(line.text)) {
    return false;
  }
  line.number = ++line_number_;
  if (line.text.ends_with('\r')) {
    line.text.remove_suffix(1);
  }
  if (is_too_long_) {
    Skip(line, "is longer than 128 MiB");
  } else if (line.text.empty()) {
    line.kind = AlogLine::Kind::kBlank;
  } else if (line.text[0] == '%') {
    line.kind = AlogLine::Kind::kComment;
    ReadComment(line.text);
  } else if (const char* problem = ReadEntry(line.text, entry)) {
    Skip(line, problem);
  } else {
    line.kind = AlogLine::Kind::kEntry;
  }
  return true;
}

void AlogReader::Skip(AlogLine& line, const char* problem) {
  line.kind = AlogLine::Kind::kBroken;
  line.problem = problem;
  ++skipped_;
  if (first_skipped_.size() < kMostExamples) {
    first_skipped_.push_back({line.number, problem});
  }
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

const char* AlogReader::ReadEntry(std::string_view line, AlogEntry& entry) {
  if (line.find('\0') != std::string_view::npos) {
    return "holds a NUL byte";
  }
  const std::optional<double> time = NumberOf(TakeWord(line));
  if (!time) {
    return "does not begin with a time";
  }
  entry.time = *time;
  entry.name = TakeWord(line);
  entry.source = TakeWord(line);
  if (entry.source.empty()) {
    return "ends before its source";
  }
  const std::size_t colon = entry.source.find(':');
  const bool has_aux = colon != std::string_view::npos && colon > 0;
  entry.aux = has_aux ? entry.source.substr(colon + 1) : std::string_view{};
  entry.source = entry.source.substr(0, has_aux ? colon : std::string_view::npos);
  SkipBlanks(line);
  if (line.ends_with(' ')) {
    line.remove_suffix(1);
  }
  ReadValue(line, entry);
  // An empty string is a value in our logs; MOOS's tools drop such a line.
  return has_escapes_ || !entry.value.empty() ? nullptr : "has no value";
}

void AlogReader::ReadValue(std::string_view text, AlogEntry& entry) {
  const bool is_marked_string = has_type_marks_ && text.starts_with("S:");
  const bool is_marked_number = has_type_marks_ && text.starts_with("D:");
  text.remove_prefix(is_marked_string || is_marked_number ? 2 : 0);
  const std::string_view bare = WithoutTrailingBlanks(text);
  entry.number = is_marked_string ? std::nullopt : NumberOf(bare);
  entry.value = entry.number ? bare : text;
  if (has_escapes_ && text.find('\\') != std::string_view::npos) {
    unescaped_.clear();
    AppendUnescaped(unescaped_, text);
    entry.value = unescaped_;
  }
}

}  // namespace limpet
