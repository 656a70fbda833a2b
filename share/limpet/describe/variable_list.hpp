// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "limpet/topics/variable.hpp"

namespace limpet {

/// Apps by the variable that they subscribe to. An app that hears everything is listed under `*`.
using Readers = std::map<std::string, std::set<std::string>>;

/// What the apps of a mission subscribe to when they are built. Writes nothing. Throws ConfigError.
[[nodiscard]] Readers ReadersOf(const std::filesystem::path& mission_folder);

[[nodiscard]] std::string PlainText(const Variable& variable, const Readers& readers);
[[nodiscard]] std::string Json(const std::vector<Variable>& variables, const Readers& readers);
/// The page docs/variables.md.
[[nodiscard]] std::string Markdown(const std::vector<Variable>& variables, const Readers& readers);

}  // namespace limpet
