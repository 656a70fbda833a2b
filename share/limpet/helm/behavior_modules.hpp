// SPDX-License-Identifier: MIT
// Behaviors that lie outside the program, each in a shared object of its own: `libBHV_Name.so`.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "limpet/core/config.hpp"

namespace limpet {

/// Folders, several separated by `:`, from which every program takes behaviors.
inline constexpr const char* kBehaviorPathVariable = "LIMPET_BEHAVIOR_PATH";

/// Loads every `libBHV_*.so` of the folders that `lines` name, relative ones from
/// `mission_folder`, and of those that the environment names; each once in the life of the program.
/// What is in them is in BehaviorRegistry then. Throws ConfigError, which names file and cause: a
/// folder that is missing; an object that was built against another version of Limpet, cannot be
/// loaded, lacks the behavior that it is called after, or has one that Limpet has itself.
void LoadBehaviorModules(std::span<const ConfigEntry> lines,
                         const std::filesystem::path& mission_folder);

}  // namespace limpet
