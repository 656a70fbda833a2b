// SPDX-License-Identifier: MIT
#include "limpet/helm/toggled_switches.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/core/number_text.hpp"
#include "limpet/helm/duration_clock.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

/// What parameters allow that are on or off.
constexpr std::array<std::string_view, 2> kSwitchForms{"true or false", "true, false or best"};

/// A parameter that is on or off, by all its names.
struct Switch {
  std::vector<std::string> names;
  bool is_on_by_default = false;

  [[nodiscard]] bool IsNamed(std::string_view key) const {
    return std::ranges::any_of(
        names, [key](const std::string& name) { return EqualsIgnoringCase(name, key); });
  }
};

/// Of what every behavior knows one can be toggled; `perpetual` cannot in MOOS-IvP either.
std::optional<Switch> SwitchOf(std::string_view key, const std::string& behavior) {
  Switch decay{.names = {"duration_idle_decay"},
               .is_on_by_default = DurationSettings{}.counts_idle_time};
  if (decay.IsNamed(key)) return decay;
  const auto entry = BehaviorRegistry().find(behavior);
  if (entry == BehaviorRegistry().end()) return std::nullopt;
  for (const ParamSpec& spec : entry->second.describe()) {
    if (std::ranges::find(kSwitchForms, spec.allowed) == kSwitchForms.end()) continue;
    Switch found{.names = spec.aliases,
                 .is_on_by_default = ParseFlag(spec.default_text).value_or(false)};
    found.names.push_back(spec.name);
    if (found.IsNamed(key)) return found;
  }
  return std::nullopt;
}

}  // namespace

ConfigEntry WithoutToggle(const ConfigEntry& part, const ConfigBlock& block) {
  if (!EqualsIgnoringCase(Trim(part.value), "toggle")) return part;
  const std::optional<Switch> known = SwitchOf(part.key, block.name);
  if (!known) return part;
  bool is_on = known->is_on_by_default;
  for (const ConfigEntry& entry : block.entries) {
    if (known->IsNamed(entry.key)) is_on = ParseFlag(entry.value).value_or(is_on);
  }
  ConfigEntry plain = part;
  plain.value = is_on ? "false" : "true";
  return plain;
}

ConfigBlock WithoutToggles(ConfigBlock block) {
  const std::vector<ConfigEntry> entries = std::exchange(block.entries, {});
  for (const ConfigEntry& entry : entries)
    block.entries.push_back(WithoutToggle(entry, block));
  return block;
}

}  // namespace limpet
