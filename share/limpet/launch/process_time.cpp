// SPDX-License-Identifier: MIT
#include "limpet/launch/process_time.hpp"

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace limpet {

std::optional<double> internal::ProcessorTicksIn(std::string_view stat) {
  // The second field is the program's name in brackets, and may hold blanks and brackets itself.
  const std::size_t name_end = stat.rfind(')');
  if (name_end == std::string_view::npos) return std::nullopt;
  std::istringstream fields{std::string(stat.substr(name_end + 1))};
  constexpr int kBetween = 11;  // from the third field to the thirteenth
  std::string skipped;
  for (int i = 0; i < kBetween; ++i) {
    fields >> skipped;
  }
  double user = 0.0, system = 0.0;
  if (!(fields >> user >> system)) return std::nullopt;
  return user + system;
}

std::optional<Seconds> ProcessorTime(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/stat", process));
  const std::string stat{std::istreambuf_iterator<char>(in), {}};
  const std::optional<double> ticks = internal::ProcessorTicksIn(stat);
  if (!ticks) return std::nullopt;
  return Seconds(*ticks / static_cast<double>(::sysconf(_SC_CLK_TCK)));
}

}  // namespace limpet
