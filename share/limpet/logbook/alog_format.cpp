// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_format.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "limpet/logbook/alog_escape.hpp"

namespace limpet {
namespace {

/// What would end a word, or (NUL) mark its line as damaged.
bool EndsWord(char c) { return c == ' ' || (c >= '\t' && c <= '\r') || c == '\0'; }

/// Left-justifies what was appended since `begin`.
void PadFrom(std::string& out, std::size_t begin, std::size_t width) {
  out.append(begin + width - std::min(out.size(), begin + width), ' ');
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

void AppendLogWord(std::string& out, std::string_view word, std::size_t width) {
  const std::size_t begin = out.size();
  out += word;
  for (std::size_t i = begin; i < out.size(); ++i) {
    out[i] = EndsWord(out[i]) ? '_' : out[i];
  }
  PadFrom(out, begin, width);
  out += ' ';
}

void AppendLogBanner(std::string& out, std::string_view file_name, Seconds start, Seconds utc,
                     std::string_view notes) {
  const std::string rule(59, '%');
  out += rule;
  out += fmt::format("\n%% LOG FILE:       ./{}\n", file_name);
  out += fmt::format("%% FILE OPENED ON  {}\n", CalendarText(utc));
  // MOOS's reader ends this number at white space only: the blank matters.
  out += fmt::format("%% LOGSTART        {:>20.16g} \n", start.value());
  out += notes;
  out += rule + "\n";
}

AlogFormat::AlogFormat(Seconds start, AlogOptions options)
    : start_(start), options_(std::move(options)) {}

void AlogFormat::AppendBanner(std::string& out, std::string_view file_name) const {
  std::string notes(kAlogEscapeNotice);
  notes += options_.marks_data_type ? "\n%% DATATYPE MARKING ON\n" : "\n";
  AppendLogBanner(out, file_name, start_, Seconds(start_.value() / options_.time_warp), notes);
}

void AlogFormat::AppendLine(std::string& out, const Message& message,
                            std::string_view blog_marker) const {
  const double time = (message.time - start_).value();
  std::size_t begin = out.size();
  fmt::format_to(std::back_inserter(out), "{:.5f}", std::isfinite(time) ? time : 0.0);
  PadFrom(out, begin, 15);
  out += ' ';
  AppendLogWord(out, message.name.empty() ? "_" : message.name, 20);
  AppendSource(out, message);
  if (const auto* number = std::get_if<double>(&message.value)) {
    out += options_.marks_data_type ? "D:" : "";
    begin = out.size();
    fmt::format_to(std::back_inserter(out), "{:.{}f}", *number, options_.double_precision);
    PadFrom(out, begin, 12);
  } else if (const auto* text = std::get_if<std::string>(&message.value)) {
    out += options_.marks_data_type ? "S:" : "";
    AppendEscaped(out, *text);
  } else {
    out += blog_marker;
  }
  out += " \n";
}

void AlogFormat::AppendSource(std::string& out, const Message& message) const {
  std::string source = message.source.empty() ? "unknown" : message.source;
  if (options_.has_source_aux && !message.source_aux.empty()) {
    source += ":" + message.source_aux;
  }
  if (options_.marks_other_communities && !message.community.empty() &&
      message.community != options_.community) {
    source += "@" + message.community;
  }
  AppendLogWord(out, source, 15);
}

}  // namespace limpet
