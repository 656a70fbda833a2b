// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "limpet/console/command.hpp"
#include "limpet/logbook/alog_reader.hpp"

namespace limpet {

/// Which entries a command is about: names and sources by pattern, times, a text in the value.
class EntryFilter {
 public:
  /// Options that Of understands, for a Command.
  [[nodiscard]] static std::vector<CommandOption> Options();
  /// A filter of names alone, given as patterns; without any it accepts every variable.
  explicit EntryFilter(std::vector<std::string> names) : names_(std::move(names)) {}
  /// `names` as above. Throws UsageError.
  [[nodiscard]] static EntryFilter Of(const Arguments& given, std::vector<std::string> names);

  [[nodiscard]] bool Accepts(const AlogEntry& entry);

 private:
  [[nodiscard]] bool AcceptsName(std::string_view name);

  std::vector<std::string> names_;
  std::vector<std::string> sources_;
  std::optional<double> from_;
  std::optional<double> to_;
  std::optional<std::string> part_of_value_;
  std::unordered_map<std::string, bool> verdicts_;  ///< on names
  std::string key_;
};

}  // namespace limpet
