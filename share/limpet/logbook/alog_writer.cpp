// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_writer.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/logbook/alog_escape.hpp"

namespace limpet {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{256} << 10U;
constexpr std::string_view kBlanks = " \t\r\n\v\f";

bool WriteAll(std::FILE* file, const void* data, std::size_t size) {
  return std::fwrite(data, 1, size, file) == size;
}

/// Appends a word (blanks in it become `_`), padded to `width` and followed by a blank.
void AppendWord(std::string& out, std::string_view word, std::size_t width) {
  const std::size_t begin = out.size();
  out += word;
  for (std::size_t i = begin; i < out.size(); ++i) {
    out[i] = kBlanks.find(out[i]) == std::string_view::npos ? out[i] : '_';
  }
  out.append(begin + width - std::min(out.size(), begin + width) + 1, ' ');
}

}  // namespace

std::string CalendarText(Seconds utc) {
  using std::chrono::days;
  using std::chrono::seconds;
  constexpr std::array<const char*, 7> kDays{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
  constexpr std::array<const char*, 12> kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  // Clamped to the years that a calendar can name.
  const double whole = std::clamp(std::floor(utc.value()), 0.0, 2.5e11);
  const std::chrono::sys_seconds at{seconds{static_cast<std::int64_t>(whole)}};
  const auto midnight = std::chrono::floor<days>(at);
  const std::chrono::year_month_day date{midnight};
  const std::chrono::hh_mm_ss clock{at - midnight};
  return fmt::format(
      "{} {} {:2} {:02}:{:02}:{:02} {}", kDays[std::chrono::weekday{midnight}.c_encoding()],
      kMonths[static_cast<unsigned>(date.month()) - 1U], static_cast<unsigned>(date.day()),
      clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
      static_cast<int>(date.year()));
}

AlogWriter::AlogWriter(Handle file, std::filesystem::path path, Seconds start, AlogOptions options)
    : file_(std::move(file)), path_(std::move(path)), start_(start), options_(std::move(options)) {}

Expected<AlogWriter> AlogWriter::Open(const std::filesystem::path& file, Seconds start,
                                      const AlogOptions& options) {
  Handle handle(std::fopen(file.c_str(), "wb"));
  if (!handle) {
    return Error{fmt::format("`{}` cannot be created", file.string())};
  }
  AlogWriter writer(std::move(handle), file, start, options);
  writer.WriteBanner();
  return writer;
}

AlogWriter::~AlogWriter() { Flush(); }

void AlogWriter::WriteBanner() {
  const std::string rule(59, '%');
  buffer_ += rule;
  buffer_ += fmt::format("\n%% LOG FILE:       ./{}\n", path_.filename().string());
  buffer_ += fmt::format("%% FILE OPENED ON  {}\n", CalendarText(start_));
  // MOOS's reader ends this number at white space only: the blank matters.
  buffer_ += fmt::format("%% LOGSTART        {:>20.16g} \n", start_.value());
  buffer_ += kAlogEscapeNotice;
  buffer_ += '\n';
  if (options_.marks_data_type) {
    buffer_ += "%% DATATYPE MARKING ON\n";
  }
  buffer_ += rule + "\n";
}

void AlogWriter::Write(const Message& message) {
  const double time = (message.time - start_).value();
  const std::size_t begin = buffer_.size();
  fmt::format_to(std::back_inserter(buffer_), "{:.5f}", std::isfinite(time) ? time : 0.0);
  buffer_.append(begin + 15 - std::min(buffer_.size(), begin + 15) + 1, ' ');
  AppendWord(buffer_, message.name.empty() ? "_" : message.name, 20);
  AppendSource(message);
  AppendValue(message.value);
  buffer_ += " \n";
  if (buffer_.size() > kBufferBytes) {
    is_good_ = WriteAll(file_.get(), buffer_.data(), buffer_.size()) && is_good_;
    buffer_.clear();
  }
}

void AlogWriter::AppendSource(const Message& message) {
  std::string source = message.source.empty() ? "unknown" : message.source;
  if (options_.has_source_aux && !message.source_aux.empty()) {
    source += ":" + message.source_aux;
  }
  if (options_.marks_other_communities && !message.community.empty() &&
      message.community != options_.community) {
    source += "@" + message.community;
  }
  AppendWord(buffer_, source, 15);
}

void AlogWriter::AppendValue(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    buffer_ += options_.marks_data_type ? "D:" : "";
    const std::size_t begin = buffer_.size();
    fmt::format_to(std::back_inserter(buffer_), "{:.{}f}", *number, options_.double_precision);
    buffer_.append(begin + 12 - std::min(buffer_.size(), begin + 12), ' ');
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    buffer_ += options_.marks_data_type ? "S:" : "";
    AppendEscaped(buffer_, *text);
  } else {
    AppendBinary(std::get<Binary>(value));
  }
}

void AlogWriter::AppendBinary(const Binary& bytes) {
  std::filesystem::path blog = path_;
  blog.replace_extension(".blog");
  if (!blog_) {
    blog_.reset(std::fopen(blog.c_str(), "wb"));
  }
  is_good_ = blog_ && WriteAll(blog_.get(), bytes.data(), bytes.size()) && is_good_;
  buffer_ += fmt::format("<MOOS_BINARY>File={},Offset={},Bytes={}</MOOS_BINARY>",
                         blog.filename().string(), blog_bytes_, bytes.size());
  blog_bytes_ += bytes.size();
}

bool AlogWriter::Flush() {
  if (!file_) {
    return is_good_;  // moved from
  }
  is_good_ = WriteAll(file_.get(), buffer_.data(), buffer_.size()) && is_good_;
  buffer_.clear();
  is_good_ = std::fflush(file_.get()) == 0 && is_good_;
  is_good_ = (!blog_ || std::fflush(blog_.get()) == 0) && is_good_;
  return is_good_;
}

bool AlogWriter::Sync() {
  is_good_ = Flush() && ::fdatasync(::fileno(file_.get())) == 0;
  is_good_ = (!blog_ || ::fdatasync(::fileno(blog_.get())) == 0) && is_good_;
  return is_good_;
}

}  // namespace limpet
