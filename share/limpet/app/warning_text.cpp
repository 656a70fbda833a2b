// SPDX-License-Identifier: MIT
#include "limpet/app/warning_text.hpp"

#include <algorithm>

namespace limpet {
namespace {

constexpr std::string_view kBetweenWarnings = "; ";
constexpr std::string_view kAfterId = ": ";
constexpr std::string_view kNoWarnings = "none";

}  // namespace

std::string EncodeWarnings(const std::map<std::string, std::string>& warnings) {
  std::string text;
  for (const auto& [id, meaning] : warnings) {
    std::string part = id;
    part += std::string(kAfterId) + meaning;
    std::ranges::replace(part, ';', ',');
    text += (text.empty() ? "" : std::string(kBetweenWarnings)) + part;
  }
  return text.empty() ? std::string(kNoWarnings) : text;
}

std::map<std::string, std::string> DecodeWarnings(std::string_view text) {
  std::map<std::string, std::string> warnings;
  while (!text.empty() && text != kNoWarnings) {
    const std::string_view part = text.substr(0, text.find(kBetweenWarnings));
    text.remove_prefix(std::min(text.size(), part.size() + kBetweenWarnings.size()));
    const std::size_t end_of_id = part.find(kAfterId);
    const bool has_text = end_of_id != std::string_view::npos;
    warnings.try_emplace(
        std::string(part.substr(0, end_of_id)),
        has_text ? std::string(part.substr(end_of_id + kAfterId.size())) : std::string());
  }
  return warnings;
}

}  // namespace limpet
