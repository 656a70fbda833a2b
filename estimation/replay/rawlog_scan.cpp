// SPDX-License-Identifier: MIT
#include "estimation/replay/rawlog_scan.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace limpet {
namespace {

constexpr std::string_view kNamespace = "mrpt::obs::";
constexpr std::uint8_t kNewForm = 0x80;  // of objects that say their end

}  // namespace

std::string_view ClassAt(std::string_view bytes) {
  if (bytes.empty()) return {};
  const auto first = static_cast<std::uint8_t>(bytes.front());
  const std::size_t length = first & 0x7FU;
  if ((first & kNewForm) == 0 || bytes.size() < 1 + length) return {};
  std::string_view name = bytes.substr(1, length);
  const bool is_name = std::ranges::all_of(
      name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == ':'; });
  if (!is_name || name.size() < 3) return {};
  if (name.starts_with(kNamespace)) name.remove_prefix(kNamespace.size());
  return name;
}

std::size_t NextObservation(std::string_view bytes, std::size_t from) {
  constexpr std::string_view kKind = "CObservation";
  for (std::size_t at = bytes.find(kKind, from); at != std::string_view::npos;
       at = bytes.find(kKind, at + 1)) {
    for (const std::size_t before : {std::size_t{1}, 1 + kNamespace.size()}) {
      if (at >= from + before && ClassAt(bytes.substr(at - before)).starts_with(kKind)) {
        return at - before;
      }
    }
  }
  return bytes.size();
}

}  // namespace limpet
