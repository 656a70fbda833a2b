// SPDX-License-Identifier: MIT
#include "limpet/app/app_example.hpp"

#include <fmt/format.h>

namespace limpet {

std::string AppExample(const std::string& process, const AppEntry& entry) {
  std::string text =
      fmt::format("ProcessConfig = {}\n{{\n  AppTick = {:g}\n", process, entry.default_tick_hz);
  for (const ParamSpec& spec : entry.describe()) {
    const std::string comment = (spec.is_required ? "required: " : "") + spec.help;
    for (const std::string& value : spec.example) {
      text +=
          fmt::format("  {} = {}{}\n", spec.name, value, comment.empty() ? "" : "  // " + comment);
    }
  }
  return text + "}\n";
}

}  // namespace limpet
