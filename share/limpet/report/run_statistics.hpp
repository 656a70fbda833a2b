// SPDX-License-Identifier: MIT
// What many runs of one configuration have in common: means, deviations, rates.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"

namespace limpet {

/// Samples of one number; absent ones (a level never reached) are counted too.
class Statistic {
 public:
  void Add(const std::optional<double>& sample);
  [[nodiscard]] std::size_t asked() const { return asked_; }
  [[nodiscard]] std::size_t count() const { return samples_.size(); }
  [[nodiscard]] double mean() const;
  /// Sample standard deviation (n - 1); 0 for fewer than two samples.
  [[nodiscard]] double sd() const;

 private:
  std::vector<double> samples_;
  std::size_t asked_ = 0;
};

/// How often something went well.
struct Rate {
  int good = 0;
  int of = 0;
  void Add(bool is_good) { good += is_good ? 1 : 0, ++of; }
};

struct OpiStatistics {
  Rate found;
  Statistic error_m, aligned_error_m, centroid_error_m, sd_horizontal_m, sd_vertical_m;
};

struct StatusStatistics {
  std::string expected;
  Rate right;
  Statistic probability;
};

struct SessionStatistics {
  std::map<double, Statistic> seabed_path_m, band_path_m;  ///< by level
  Statistic prior_opis_seen_path_m, path_m, duration_s, realtime_factor;
  Statistic position_rmse_m, aligned_rmse_m, final_error_m, dead_reckoning_final_error_m, nees;
  Statistic home_error_m;
  Rate home;     ///< ended home and truly within 3 m of the start point
  Rate covered;  ///< 95 % of bottom and band seen
  Rate none_missed, none_invented;
  Rate all_within_1m;   ///< every object found, none off by more than 1 m
  Rate statuses_right;  ///< with a former session: every status right, no decision about nothing
  std::map<std::string, OpiStatistics> opis;
  std::map<std::string, StatusStatistics> statuses;
};

struct RunStatistics {
  std::string mission;
  int runs = 0;                       ///< with a report
  std::vector<std::uint64_t> failed;  ///< seeds that left none
  Rate flawless;                      ///< all of the rates good in every session
  std::map<std::string, SessionStatistics> sessions;

  /// Adds one run's report.json, or says why it cannot be read. A report that is refused changes
  /// nothing.
  [[nodiscard]] std::optional<Error> Add(const std::string& report_json);
};

}  // namespace limpet
