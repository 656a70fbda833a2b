// SPDX-License-Identifier: MIT
#include "limpet/console/progress_line.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/console/shown_text.hpp"

namespace limpet {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};
constexpr int kBarWidth = 24;

std::string Bar(double done) {
  const int filled = std::clamp(static_cast<int>(std::lround(done * kBarWidth)), 0, kBarWidth);
  return std::string(static_cast<std::size_t>(filled), '#') +
         std::string(static_cast<std::size_t>(kBarWidth - filled), '.');
}

}  // namespace

ProgressLine::ProgressLine(std::string label, std::FILE* out)
    : label_(OneLine(label)), out_(out), is_terminal_(isatty(fileno(out)) != 0) {}

ProgressLine::~ProgressLine() {
  if (has_open_line_) std::fputc('\n', out_);
}

bool ProgressLine::IsDue(double done) const {
  if (!is_terminal_)
    return last_done_ < 0.0 || std::floor(done * 10.0) > std::floor(last_done_ * 10.0);
  return done >= 1.0 || std::chrono::steady_clock::now() - last_time_ >= kRedraw;
}

void ProgressLine::Update(double done, const std::string& detail) {
  if (IsDue(done)) Announce(done, detail);
}

void ProgressLine::Announce(double done, const std::string& detail) {
  last_done_ = std::max(last_done_, done);
  if (is_terminal_) {
    last_time_ = std::chrono::steady_clock::now();
    fmt::print(out_, "\r\033[K{} [{}] {:3.0f} %  {}", label_, Bar(done), 100.0 * done, detail);
    has_open_line_ = true;
  } else {
    fmt::print(out_, "{} {:3.0f} %  {}\n", label_, 100.0 * done, detail);
  }
  std::fflush(out_);
}

void ProgressLine::Note(const std::string& text) {
  fmt::print(out_, "{}{}\n", has_open_line_ ? "\r\033[K" : "", text);
  has_open_line_ = false;
  std::fflush(out_);
}

}  // namespace limpet
