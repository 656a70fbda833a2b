// SPDX-License-Identifier: MIT
// What several blocks of a mission need and the mission says once, as a global: it reaches every
// block that takes it and does not say it itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

struct SharedSetting {
  /// A parameter of an app's or a behavior's block.
  struct Taker {
    const char* owner;  ///< process, or type of the behavior
    const char* key;
  };
  const char* global;
  const char* meaning;
  std::vector<Taker> takers;
  bool is_one_fact = true;  ///< all takers must agree, also where the mission has no global
};

[[nodiscard]] const std::vector<SharedSetting>& SharedSettings();

/// The global that stands in for a parameter where its block does not say it; "" if none does.
[[nodiscard]] std::string_view GlobalFor(std::string_view owner, std::string_view key);

/// Gives a block of `owner` what it takes from `globals` and does not say itself, each entry with
/// the global's line. The first global of a name counts.
void TakeGlobals(const std::vector<ConfigEntry>& globals, std::string_view owner,
                 ConfigBlock& block);
/// The same for blocks that are named after their owner, as behaviors are.
void TakeGlobals(const std::vector<ConfigEntry>& globals, std::vector<ConfigBlock>& blocks);

}  // namespace limpet
