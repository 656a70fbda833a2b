// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace limpet {

/// What was said of a status, with what probability, and whether it was so.
struct Saying {
  double probability = 0.0;
  bool is_true = false;
};

/// Verdicts of many change sessions beside the truth.
class VerdictTally {
 public:
  /// Takes what `report.json` of one run says of its change session.
  void Add(std::uint64_t seed, const nlohmann::json& report);
  /// Several lines for the terminal.
  [[nodiscard]] std::string Text() const;

 private:
  void AddChange(std::uint64_t seed, const nlohmann::json& change);

  int sessions_ = 0;
  std::map<std::string, int> ended_;
  std::map<std::string, std::vector<Saying>> sayings_;          ///< by status
  std::map<std::string, std::map<std::string, int>> verdicts_;  ///< by truth, by what was decided
  std::vector<Saying> decided_;
  std::vector<std::string> wrong_;  ///< in words, those that were said to be surest
};

}  // namespace limpet
