// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limpet {

/// The LimpetDB `program` as a process that listens on `port`; ends this one if it does not start.
inline pid_t StartBroker(std::uint16_t port, const std::string& program) {
  const pid_t child = fork();
  if (child == 0) {
    const std::string option = fmt::format("--moos_port={}", port);
    execl(program.c_str(), "LimpetDB", option.c_str(), nullptr);
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  if (waitpid(child, nullptr, WNOHANG) != 0) {
    fmt::print(stderr, "{} does not start\n", program);
    std::exit(2);
  }
  return child;
}

}  // namespace limpet
