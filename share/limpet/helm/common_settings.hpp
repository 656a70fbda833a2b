// SPDX-License-Identifier: MIT
// What every behavior's block may say; the host heeds it, not the behavior.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/helm/duration_clock.hpp"
#include "limpet/helm/flag_lists.hpp"
#include "limpet/mission/condition.hpp"

namespace limpet {

/// Whether behaviors are made from the block while the helm runs.
enum class Templating {
  kDisallow,  ///< one behavior, made at the start
  kSpawn,     ///< one for each update that names a new one
  kClone      ///< one at the start, and more as with kSpawn
};

/// A variable without which a behavior does not run: idle when its last mail is older.
struct StarveLimit {
  std::string variable;
  Seconds oldest;
};

struct CommonSettings {
  std::string name;
  double weight = 100.0;  ///< `pwt`
  std::vector<Condition> conditions{};
  FlagLists flags{};
  std::string updates_variable{};
  bool is_perpetual = false;  ///< goes on living after it has completed
  DurationSettings duration{};
  std::vector<StarveLimit> starve_limits{};
  std::map<std::string, std::string, std::less<>> post_mapping{};  ///< `silent`: not posted
  Templating templating = Templating::kDisallow;
  int max_spawnings = 0;  ///< 0: no limit
};

/// Reads them from a block, whose other keys are the behavior's own; adds every problem.
[[nodiscard]] CommonSettings ReadCommonSettings(const ConfigBlock& block,
                                                std::vector<ConfigProblem>& problems);

/// All keys that it reads, aliases included, and those that it knows and does not heed.
[[nodiscard]] const std::vector<std::string>& CommonBehaviorKeys();
/// True for keys of which a block may have several lines: flags, conditions and the like.
[[nodiscard]] bool IsRepeatableCommonKey(std::string_view key);
/// True for keys of existing missions that have no effect here.
[[nodiscard]] bool IsIgnoredCommonKey(std::string_view key);

}  // namespace limpet
