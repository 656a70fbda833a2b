// SPDX-License-Identifier: MIT
// pShare's block as a mission file has it: registered under its name, checked with its lines.
#include <fmt/format.h>

#include "apps/pShare/share_app.hpp"
#include "limpet/app/registry.hpp"

namespace limpet {
namespace {

/// What is wrong with one `output` or `input` line; other lines are not looked at.
std::optional<Error> CheckLine(const ConfigEntry& entry, const ShareParams& params) {
  if (EqualsIgnoringCase(entry.key, "output")) {
    auto outputs = ParseShareOutputs(entry.value, params.Multicast());
    if (!outputs) {
      return outputs.error();
    }
    auto error = Settle(outputs->front().security, params.Security());
    return error ? error : SettleReceiver(outputs->front(), params.to);
  }
  if (EqualsIgnoringCase(entry.key, "input")) {
    auto input = ParseShareInput(entry.value, params.Multicast());
    return input ? Settle(input->security, params.Security()) : input.error();
  }
  return std::nullopt;
}

}  // namespace

std::vector<ConfigProblem> CheckShareBlock(const ConfigBlock& block) {
  ShareParams params;
  std::vector<ConfigProblem> problems = ApplyBlock(block, DescribeParams(params), CommonAppKeys());
  for (const ConfigEntry& entry : block.entries) {
    if (const auto error = CheckLine(entry, params)) {
      problems.push_back(
          {entry.where, entry.key, fmt::format("`{}` {}", entry.value, error->text)});
    }
  }
  return problems;
}

namespace {

/// Registers as LIMPET_REGISTER_APP does, with a check that reads the lines too, and MOOS's
/// switches.
const bool is_registered = [] {
  AppEntry entry = MakeAppEntry<ShareApp>(4.0);
  entry.check = CheckShareBlock;
  entry.switches = {{"o", "output"}, {"output", "output"}, {"i", "input"}, {"input", "input"}};
  AppRegistry()["pShare"] = std::move(entry);
  return true;
}();

}  // namespace

}  // namespace limpet
