// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

namespace limpet {

/// A terminal of 50 x 10, or what it is set to, whose other end is a child process.
class PseudoTerminal {
 public:
  explicit PseudoTerminal(unsigned short columns = 50)
      : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(master_);
    ::unlockpt(master_);
    slave_ = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);  // NOLINT(concurrency-mt-unsafe)
    SetColumns(columns);
    ::tcgetattr(slave_, &before_);
  }
  ~PseudoTerminal() {
    ::close(master_);
    ::close(slave_);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void SetColumns(unsigned short columns) const {
    const winsize size{.ws_row = 10, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    ::ioctl(slave_, TIOCSWINSZ, &size);
  }
  /// A stream to the terminal, for what writes to one in this process. The caller closes it.
  [[nodiscard]] std::FILE* Open() const { return ::fdopen(::dup(slave_), "w"); }
  /// What has been written until now.
  [[nodiscard]] std::string Written() const {
    std::string output;
    pollfd in{.fd = master_, .events = POLLIN, .revents = 0};
    std::array<char, 4096> bytes{};
    while (::poll(&in, 1, 0) > 0) {
      const ssize_t count = ::read(master_, bytes.data(), bytes.size());
      if (count <= 0) {
        break;
      }
      output.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return output;
  }

  /// Runs `body` in a child on this terminal; gives how it ended and all it wrote.
  template <class Body>
  std::pair<int, std::string> Run(Body body) {
    std::fflush(stdout);  // or the child, too, writes what waits there
    const pid_t child = ::fork();
    if (child == 0) {
      ::dup2(slave_, STDIN_FILENO);
      ::dup2(slave_, STDOUT_FILENO);
      ::_exit(body());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {status, Written()};
  }
  /// Waits for such output, at most 5 s, and swallows it.
  bool Await(std::string_view text) const {
    std::string output;
    pollfd in{.fd = master_, .events = POLLIN, .revents = 0};
    std::array<char, 4096> bytes{};
    while (output.find(text) == std::string::npos && ::poll(&in, 1, 5000) > 0) {
      const ssize_t count = ::read(master_, bytes.data(), bytes.size());
      output.append(bytes.data(), static_cast<std::size_t>(count > 0 ? count : 0));
    }
    return output.find(text) != std::string::npos;
  }
  void Type(std::string_view keys) const {
    EXPECT_EQ(::write(master_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  [[nodiscard]] bool IsAsBefore() const {
    termios after{};
    ::tcgetattr(slave_, &after);
    return after.c_lflag == before_.c_lflag && after.c_iflag == before_.c_iflag &&
           after.c_oflag == before_.c_oflag;
  }

 private:
  int master_;
  int slave_ = -1;
  termios before_{};
};

}  // namespace limpet
