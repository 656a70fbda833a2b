// SPDX-License-Identifier: MIT
#include "limpet/tuning/parameter_space.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/random.hpp"

namespace limpet {

Expected<VariedParameter> VariedParameter::Parse(std::string_view text) {
  const auto complain = [text](const std::string& why) {
    return Error{
        fmt::format("`{}`: {}; owner.key=low:high or owner.key=low:high:levels is "
                    "expected, e.g. cover.frontier_weight=0:1:5",
                    text, why)};
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return complain("no `=`");
  VariedParameter parameter{.name = std::string(Trim(text.substr(0, equals)))};
  const std::size_t dot = parameter.name.find('.');
  if (dot == 0 || dot == std::string::npos || dot + 1 == parameter.name.size()) {
    return complain("names no owner and key");
  }
  const std::vector<std::string> parts = Split(text.substr(equals + 1), ':');
  if (parts.size() != 2 && parts.size() != 3) return complain("no range");
  const auto low = ParseNumber(Trim(parts[0])), high = ParseNumber(Trim(parts[1]));
  if (!low || !high) return complain("a bound is no number");
  if (*low >= *high) return complain("the lower bound is not below the upper one");
  parameter.low = *low;
  parameter.high = *high;
  if (parts.size() == 3) {
    const auto levels = ParseInteger(Trim(parts[2]));
    if (!levels || *levels < 2 || *levels > kMostLevels) {
      return complain(fmt::format("levels must be 2 to {}", kMostLevels));
    }
    parameter.levels = static_cast<int>(*levels);
  }
  return parameter;
}

double VariedParameter::ValueAt(double share) const {
  double clamped = std::clamp(share, 0.0, 1.0);
  if (levels > 1) clamped = std::round(clamped * (levels - 1)) / (levels - 1);
  // Twelve digits: a level like 0.3 must not become 0.30000000000000004 in a mission.
  const double value = low + clamped * (high - low);
  return ParseNumber(fmt::format("{:.12g}", value)).value_or(value);
}

std::string VariedParameter::Text() const {
  return fmt::format("{}={}:{}{}", name, TextOf(low), TextOf(high),
                     levels > 0 ? fmt::format(":{}", levels) : "");
}

std::vector<std::string> ParameterSpace::TextsOf(const SettingValues& setting) const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    texts.push_back(parameters_[i].name + "=" + TextOf(setting[i]));
  return texts;
}

SettingValues ParameterSpace::At(const Eigen::VectorXd& shares) const {
  SettingValues setting;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    setting.push_back(parameters_[i].ValueAt(shares(static_cast<Eigen::Index>(i))));
  return setting;
}

Eigen::VectorXd ParameterSpace::SharesOf(const SettingValues& setting) const {
  Eigen::VectorXd shares(static_cast<Eigen::Index>(parameters_.size()));
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    shares(static_cast<Eigen::Index>(i)) = parameters_[i].ShareOf(setting[i]);
  return shares;
}

Expected<std::vector<SettingValues>> ParameterSpace::Grid() const {
  std::vector<SettingValues> settings{{}};
  for (const VariedParameter& parameter : parameters_) {
    const int levels = parameter.levels > 0 ? parameter.levels : kGridLevels;
    if (settings.size() * static_cast<std::size_t>(levels) > kMostSettings) {
      return Error{fmt::format("a grid of more than {} settings; fewer levels, or --method random",
                               kMostSettings)};
    }
    std::vector<SettingValues> more;
    for (const SettingValues& setting : settings) {
      for (int level = 0; level < levels; ++level) {
        more.push_back(setting);
        more.back().push_back(parameter.ValueAt(static_cast<double>(level) / (levels - 1)));
      }
    }
    settings = std::move(more);
  }
  return settings;
}

std::vector<SettingValues> ParameterSpace::Spread(int count, std::uint64_t seed) const {
  std::vector<SettingValues> settings(static_cast<std::size_t>(count));
  for (const VariedParameter& parameter : parameters_) {
    Random random(seed, "spread of " + parameter.name);
    std::vector<int> parts(static_cast<std::size_t>(count));
    std::iota(parts.begin(), parts.end(), 0);
    for (std::size_t i = parts.size(); i > 1; --i)
      std::swap(parts[i - 1], parts[random.Index(i)]);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double share = (parts[i] + random.Uniform(0.0, 1.0)) / count;
      settings[i].push_back(parameter.ValueAt(share));
    }
  }
  std::vector<SettingValues> unique;
  for (const SettingValues& setting : settings) {
    if (std::ranges::find(unique, setting) == unique.end()) unique.push_back(setting);
  }
  return unique;
}

}  // namespace limpet
