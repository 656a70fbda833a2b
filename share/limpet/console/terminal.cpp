// SPDX-License-Identifier: MIT
#include "limpet/console/terminal.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

// Alternate screen, no cursor, no wrapping of lines that are longer than a screen that has shrunk.
constexpr std::string_view kEnter = "\033[?1049h\033[?25l\033[?7l\033[2J";
constexpr std::string_view kLeave = "\033[m\033[?7h\033[?25h\033[?1049l";

// What signal handlers need: the terminal's former state, and what has been asked for.
termios former_settings{};
volatile std::sig_atomic_t is_entered = 0;
volatile std::sig_atomic_t stop_requested = 0;

void WriteAll(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno == EAGAIN) {
      pollfd out{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
      ::poll(&out, 1, 100);
    } else if (count < 0 && errno != EINTR) {
      return;  // the terminal has gone; reading notices
    }
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
}

void Enter() {
  termios settings = former_settings;
  settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // Ctrl-C and Ctrl-Z stay signals
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  ::tcsetattr(STDIN_FILENO, TCSANOW, &settings);
  is_entered = 1;
  WriteAll(kEnter);
}

/// Safe in a signal handler.
void Leave() {
  if (is_entered != 0) {
    is_entered = 0;
    WriteAll(kLeave);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &former_settings);
  }
}

/// Puts the terminal right, then lets the signal do what it always does.
void LeaveAndDie(int signal) {
  Leave();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

constexpr std::array kDeadly{SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};

/// Without restarting interrupted calls, so that waiting for keys ends.
void Handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

std::string FrameWriter::Update(const Frame& frame, ScreenSize size) {
  std::string bytes;
  if (size != size_) {
    size_ = size;
    Forget();
  }
  const bool is_first = shown_.empty();
  shown_.resize(size.lines);
  for (std::size_t i = 0; i < size.lines; ++i) {
    std::string line = i < frame.size() ? Painted(frame[i], has_colors_) : "";
    if (is_first || line != shown_[i]) {
      // Erasing behind a full line would take its last character.
      const bool is_full = i < frame.size() && frame[i].columns() >= size.columns;
      bytes += fmt::format("\033[{};1H{}{}", i + 1, line, is_full ? "" : "\033[K");
      shown_[i] = std::move(line);
    }
  }
  return bytes;
}

bool Terminal::IsThere() {
  const char* kind = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  return kind != nullptr && std::string_view(kind) != "dumb" && ::isatty(STDIN_FILENO) != 0 &&
         ::isatty(STDOUT_FILENO) != 0;
}

Terminal::Terminal() : writer_(ColorsAreWanted()) {
  LIMPET_REQUIRE(is_entered == 0, "one terminal at a time");
  ::tcgetattr(STDIN_FILENO, &former_settings);
  for (const int signal : kDeadly) {
    Handle(signal, LeaveAndDie);
  }
  Handle(SIGTSTP, [](int) { stop_requested = 1; });
  Handle(SIGWINCH, [](int) {});
  Enter();
}

Terminal::~Terminal() {
  Leave();
  for (const int signal : kDeadly) {
    Handle(signal, SIG_DFL);
  }
  Handle(SIGTSTP, SIG_DFL);
  Handle(SIGWINCH, SIG_DFL);
}

ScreenSize Terminal::Size() const {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return {};
  }
  return {.columns = size.ws_col, .lines = size.ws_row};
}

void Terminal::Show(const Frame& frame) { WriteAll(writer_.Update(frame, Size())); }

void Terminal::StopIfAsked() {
  if (stop_requested != 0) {
    stop_requested = 0;
    Leave();
    ::raise(SIGSTOP);
    Enter();
    writer_.Forget();
  }
}

std::vector<Key> Terminal::ReadKeys(Seconds wait) {
  pollfd in{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  const int ready = ::poll(&in, 1, static_cast<int>(std::max(0.0, 1e3 * wait.value())));
  StopIfAsked();
  if (ready <= 0) {
    return {};
  }
  std::array<char, 256> bytes{};
  const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) {
    is_open_ = false;
  }
  return keys_.Feed({bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))});
}

}  // namespace limpet
