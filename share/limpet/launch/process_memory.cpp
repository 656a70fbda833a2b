// SPDX-License-Identifier: MIT
#include "limpet/launch/process_memory.hpp"

#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/core/byte_units.hpp"

namespace limpet {

std::optional<double> ResidentMib(pid_t process) {
  std::ifstream statm(fmt::format("/proc/{}/statm", process));
  double pages = 0.0, resident = 0.0;
  if (!(statm >> pages >> resident)) return std::nullopt;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / kBytesPerMib;
}

}  // namespace limpet
