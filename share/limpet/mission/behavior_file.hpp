// SPDX-License-Identifier: MIT
// Behavior files (.bhv): initial posts, mode declarations, behavior blocks.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/core/message.hpp"
#include "limpet/mission/condition.hpp"
#include "limpet/mission/plug.hpp"

namespace limpet {

/// A post at helm start-up.
struct InitialPost {
  std::string variable;
  Value value;
  bool is_deferred = false;  ///< `initialize_`: only if nobody has published it by then
  SourceLine where;
};

/// `set VAR = VALUE { conditions } ELSE`.
struct ModeDeclaration {
  std::string variable;
  std::string value;
  std::vector<Condition> conditions;
  std::string else_value;  ///< empty: none
  SourceLine where;
};

struct BehaviorFile {
  std::string file;
  std::vector<InitialPost> initializes;
  std::vector<ModeDeclaration> modes;
  std::vector<ConfigBlock> behaviors;  ///< name is the type, e.g. BHV_CoverArea; in file order
  std::vector<ConfigProblem> warnings;
};

/// The `name` of a behavior block, or its type if it has none.
[[nodiscard]] std::string BehaviorNameOf(const ConfigBlock& block);

/// Throws ConfigError with every problem: unknown top-level text, a bad condition, two behaviors of
/// one name, ... Plug directives are expanded first.
[[nodiscard]] BehaviorFile ParseBehaviors(std::string_view text, const std::string& file);
[[nodiscard]] BehaviorFile ParseBehaviors(std::string_view text, const std::string& file,
                                          const PlugOptions& options);
[[nodiscard]] BehaviorFile LoadBehaviors(const std::filesystem::path& file);

}  // namespace limpet
