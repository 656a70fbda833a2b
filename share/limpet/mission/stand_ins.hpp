// SPDX-License-Identifier: MIT
// Stock MOOS programs whose place one of Limpet's takes where they are not installed.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

struct MissionFile;

/// A line that a block is read with, unless it says the key itself, or another name of it.
struct StandInLine {
  std::string key;
  std::string value;
  std::vector<std::string> other_names{};
};

struct ProgramStandIn {
  std::string stock;
  std::string own;
  /// How the stock program behaves where its block is silent and ours would behave otherwise, and
  /// what ours must be told and missions of the stock one have no use for.
  std::vector<StandInLine> lines{};
};

/// All there are.
[[nodiscard]] std::span<const ProgramStandIn> StandIns();
/// The one for a stock program, or nullptr.
[[nodiscard]] const ProgramStandIn* StandInFor(std::string_view program);
/// Our name of a program: its own, or that of what stands in for it.
[[nodiscard]] std::string OwnNameOf(std::string_view program);
/// True if ours runs in place of `program` here: the stock one is not on PATH.
[[nodiscard]] bool IsStoodInFor(std::string_view program);

/// Adds the lines to the blocks of stock programs. What MOOS passes over in these blocks is no
/// problem of theirs and becomes a warning of the mission.
void TakeStandInLines(MissionFile& mission);

}  // namespace limpet
