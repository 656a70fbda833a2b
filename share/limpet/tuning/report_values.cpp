// SPDX-License-Identifier: MIT
#include "limpet/tuning/report_values.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

using Numbers = std::map<std::string, std::optional<double>>;

std::string EntryName(const nlohmann::json& entry, std::size_t index) {
  if (entry.is_object() && entry.contains("level") && entry.at("level").is_number()) {
    return fmt::format("{:g}", 100.0 * entry.at("level").get<double>());
  }
  return std::to_string(index);
}

void Collect(const std::string& key, const nlohmann::json& value, Numbers& numbers) {
  const auto below = [&key](const std::string& name) {
    return key.empty() ? name : key + "." + name;
  };
  if (value.is_object()) {
    for (const auto& [name, inner] : value.items())
      Collect(below(name), inner, numbers);
  } else if (value.is_array()) {
    numbers[below("count")] = static_cast<double>(value.size());
    for (std::size_t i = 0; i < value.size(); ++i)
      Collect(below(EntryName(value[i], i)), value[i], numbers);
  } else if (value.is_number() && std::isfinite(value.get<double>())) {
    numbers[key] = value.get<double>();
  } else if (value.is_boolean()) {
    numbers[key] = value.get<bool>() ? 1.0 : 0.0;
  } else if (value.is_null()) {
    numbers[key] = std::nullopt;
  }
}

}  // namespace

Expected<ReportValues> ReportValues::FromJson(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return Error{"not a report: no JSON object"};
  ReportValues values;
  Collect("", json, values.numbers_);
  return values;
}

std::optional<double> ReportValues::Find(const std::string& key) const {
  const auto found = numbers_.find(key);
  return found == numbers_.end() ? std::nullopt : found->second;
}

std::vector<std::string> ReportValues::Keys() const {
  std::vector<std::string> keys;
  keys.reserve(numbers_.size());
  for (const auto& [key, number] : numbers_)
    keys.push_back(key);
  return keys;
}

}  // namespace limpet
