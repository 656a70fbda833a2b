// SPDX-License-Identifier: MIT
#include "limpet/console/progress_line.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "limpet/console/shown_text.hpp"

namespace limpet {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::size_t kWidestBar = 24, kNarrowestBar = 4;

std::string Bar(double done, std::size_t width) {
  const auto columns = static_cast<double>(width);
  const auto filled = static_cast<std::size_t>(std::lround(std::clamp(done, 0.0, 1.0) * columns));
  return std::string(filled, '#') + std::string(width - filled, '.');
}

/// Columns of the terminal as it is now: its user may have changed it.
std::size_t ColumnsOfTerminal(std::FILE* out) {
  winsize size{};
  const bool is_known = ::ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : 80;
}

}  // namespace

ProgressLine::ProgressLine(const std::string& label, std::FILE* out)
    : label_(OneLine(label)), out_(out), is_terminal_(isatty(fileno(out)) != 0) {}

ProgressLine::~ProgressLine() {
  if (has_open_line_) std::fputc('\n', out_);
}

bool ProgressLine::IsDue(double done) const {
  if (!is_terminal_) return !last_done_ || std::floor(done * 10.0) > std::floor(*last_done_ * 10.0);
  return done >= 1.0 || std::chrono::steady_clock::now() - last_time_ >= kRedraw;
}

void ProgressLine::Update(double done, const std::string& detail) {
  if (IsDue(done)) Announce(done, detail);
}

std::string ProgressLine::LineFor(double done, const std::string& detail) const {
  // One column stays free: many terminals wrap when the last one is written.
  const std::size_t columns = ColumnsOfTerminal(out_) - 1;
  const std::string percent = fmt::format("{:3.0f} %", 100.0 * done);
  const std::size_t others = ColumnsOf(label_) + percent.size() + ColumnsOf(detail) + 6;
  std::string line = label_ + " ";
  if (columns >= others + kNarrowestBar) {  // what is going on is worth more than a bar
    line += fmt::format("[{}] ", Bar(done, std::min(kWidestBar, columns - others)));
  }
  return OneLine(fmt::format("{}{}  {}", line, percent, detail), columns);
}

void ProgressLine::Announce(double done, const std::string& detail) {
  last_done_ = std::max(last_done_.value_or(done), done);
  if (is_terminal_) {
    last_time_ = std::chrono::steady_clock::now();
    fmt::print(out_, "\r\033[K{}", LineFor(done, detail));
    has_open_line_ = true;
  } else {
    fmt::print(out_, "{} {:3.0f} %  {}\n", label_, 100.0 * done, OneLine(detail));
  }
  std::fflush(out_);
}

void ProgressLine::Note(const std::string& text) {
  fmt::print(out_, "{}{}\n", has_open_line_ ? "\r\033[K" : "", OneLine(text));
  has_open_line_ = false;
  std::fflush(out_);
}

}  // namespace limpet
