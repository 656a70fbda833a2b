// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "limpet/logbook/alog_reader.hpp"

namespace limpet {

/// Mean and spread of numbers seen one by one (Welford).
struct NumberStatistics {
  std::uint64_t count = 0;
  double least = 0.0;
  double greatest = 0.0;
  double mean = 0.0;
  double square_sum = 0.0;  ///< of deviations from the mean
  double first = 0.0;
  double last = 0.0;

  void Add(double value);
  /// Standard deviation of the population.
  [[nodiscard]] double StandardDeviation() const;
};

/// One variable of a log. Times in seconds since its start.
struct VariableStatistics {
  std::string name;
  std::uint64_t entries = 0;
  std::uint64_t bytes = 0;  ///< of its lines
  double first = 0.0;       ///< least time
  double last = 0.0;        ///< greatest time
  double longest_gap = 0.0;
  std::set<std::string, std::less<>> sources;
  NumberStatistics numbers;

  /// Entries per second between the first and the last.
  [[nodiscard]] double Rate() const;
};

/// Gathers what a log holds, line by line, in memory that grows with the number of variables alone.
class AlogStatistics {
 public:
  void Add(const AlogLine& line, const AlogEntry& entry);

  /// Sorted by name.
  [[nodiscard]] std::vector<VariableStatistics> Variables() const;
  [[nodiscard]] std::uint64_t entries() const { return entries_; }
  /// Entries with a lesser time than one before them.
  [[nodiscard]] std::uint64_t out_of_order() const { return out_of_order_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const {
      return std::hash<std::string_view>{}(name);
    }
  };
  VariableStatistics& Of(std::string_view name);

  std::unordered_map<std::string, VariableStatistics, Hash, std::equal_to<>> variables_;
  std::uint64_t entries_ = 0;
  std::uint64_t out_of_order_ = 0;
  std::uint64_t bytes_ = 0;
  double first_ = 0.0;
  double last_ = 0.0;
};

}  // namespace limpet
