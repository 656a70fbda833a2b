// SPDX-License-Identifier: MIT
// What a process has used so far, as the kernel counts it.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <sys/types.h>

namespace limpet {

/// Processor time of all threads of a process [s].
inline double ProcessorSeconds(pid_t pid) {
  double nanoseconds = 0.0;
  for (const auto& task : std::filesystem::directory_iterator(fmt::format("/proc/{}/task", pid))) {
    double of_one = 0.0;
    std::ifstream(task.path() / "schedstat") >> of_one;
    nanoseconds += of_one;
  }
  return 1e-9 * nanoseconds;
}

/// Resident now (`VmRSS`) or at most so far (`VmHWM`) [MB].
inline double Megabytes(pid_t pid, std::string_view which = "VmRSS") {
  std::ifstream status(fmt::format("/proc/{}/status", pid));
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(which)) {
      return std::stod(line.substr(which.size() + 1)) / 1024.0;
    }
  }
  return -1.0;
}

}  // namespace limpet
