// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace limpet {

/// What became of a mission's runs in one world.
class OutcomeRow {
 public:
  /// A run's report.json.
  void Add(const nlohmann::json& report);
  /// Cells of a Markdown table, with the line's end.
  [[nodiscard]] std::string Text() const;

 private:
  void AddSession(const nlohmann::json& session);

  int sessions_ = 0, home_ = 0;
  int right_ = 0, open_ = 0, wrong_ = 0, invented_ = 0, missed_ = 0;
  int objects_ = 0;
  double error_sum_m_ = 0.0, error_most_m_ = 0.0, squared_ratio_sum_ = 0.0;
  double nees_sum_ = 0.0, home_error_most_m_ = 0.0;
};

/// What the table is of, and its head.
[[nodiscard]] std::string OutcomePageHead(std::uint64_t first, std::uint64_t last);

}  // namespace limpet
