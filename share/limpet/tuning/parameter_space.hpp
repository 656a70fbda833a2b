// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/expected.hpp"

namespace limpet {

/// One parameter that is tuned, and where: `cover.frontier_weight=0:1:5`.
struct VariedParameter {
  std::string name;  ///< `behavior.key`, `app.key`
  double low = 0.0, high = 1.0;
  int levels = 0;  ///< evenly spaced values from low to high; 0: any value between

  /// `owner.key=low:high` or `owner.key=low:high:levels`.
  [[nodiscard]] static Expected<VariedParameter> Parse(std::string_view text);

  /// The value at a share of the range from 0 to 1, or the nearest level's.
  [[nodiscard]] double ValueAt(double share) const;
  [[nodiscard]] double ShareOf(double value) const { return (value - low) / (high - low); }
  [[nodiscard]] std::string Text() const;

  static constexpr int kMostLevels = 1000;
};

/// One value per varied parameter, in their order.
using SettingValues = std::vector<double>;

/// All settings that may be tried.
class ParameterSpace {
 public:
  explicit ParameterSpace(std::vector<VariedParameter> parameters)
      : parameters_(std::move(parameters)) {}

  [[nodiscard]] const std::vector<VariedParameter>& parameters() const { return parameters_; }
  /// The setting as options of a survey: `owner.key=value`.
  [[nodiscard]] std::vector<std::string> TextsOf(const SettingValues& setting) const;
  [[nodiscard]] SettingValues At(const Eigen::VectorXd& shares) const;
  /// Each coordinate in shares of its range, outside of 0 to 1 where the value is out of range.
  [[nodiscard]] Eigen::VectorXd SharesOf(const SettingValues& setting) const;

  /// Every combination of levels, the last parameter's running fastest; a parameter without levels
  /// has kGridLevels. Complains beyond kMostSettings.
  [[nodiscard]] Expected<std::vector<SettingValues>> Grid() const;
  /// A Latin hypercube: each parameter's range in `count` equal parts, one setting in each. Equal
  /// settings, which levels can make, are told once.
  [[nodiscard]] std::vector<SettingValues> Spread(int count, std::uint64_t seed) const;

  static constexpr int kGridLevels = 5;
  static constexpr std::size_t kMostSettings = 10000;

 private:
  std::vector<VariedParameter> parameters_;
};

}  // namespace limpet
