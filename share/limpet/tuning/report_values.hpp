// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"

namespace limpet {

/// The numbers of one report.json by dotted keys. What a list holds is reached by what its entries
/// are called: of a level, by its percentage (`sessions.discovery.coverage.95.path_m`), else by its
/// index from 0; `sessions.discovery.missed.count` is the length of a list. True is 1, false 0.
class ReportValues {
 public:
  /// The complaint if the text is no JSON object.
  [[nodiscard]] static Expected<ReportValues> FromJson(const std::string& text);

  [[nodiscard]] bool Has(const std::string& key) const { return numbers_.contains(key); }
  /// Nothing if the key is unknown or is null in this report.
  [[nodiscard]] std::optional<double> Find(const std::string& key) const;
  /// All keys in alphabetical order, also those whose value is null.
  [[nodiscard]] std::vector<std::string> Keys() const;

 private:
  std::map<std::string, std::optional<double>> numbers_;
};

}  // namespace limpet
