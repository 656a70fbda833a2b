// SPDX-License-Identifier: MIT
#include "limpet/launch/process_memory.hpp"

#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

namespace limpet {

std::optional<double> ResidentMib(pid_t process) {
  std::ifstream statm(fmt::format("/proc/{}/statm", process));
  double pages = 0.0, resident = 0.0;
  if (!(statm >> pages >> resident)) return std::nullopt;
  constexpr double kBytesOfMib = 1024.0 * 1024.0;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / kBytesOfMib;
}

}  // namespace limpet
