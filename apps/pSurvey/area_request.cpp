// SPDX-License-Identifier: MIT
#include "apps/pSurvey/area_request.hpp"

#include <algorithm>
#include <optional>

#include "limpet/core/config.hpp"
#include "limpet/session/checksum.hpp"

namespace limpet {
namespace {

constexpr std::string_view kHash = "hash=";

/// A request as its hash, if it has one, and what that is of.
struct SealedText {
  std::optional<std::string_view> hash;
  std::string_view body;
};
SealedText SealedTextOf(std::string_view text) {
  text = Trim(text);
  if (!text.starts_with(kHash)) return {.hash = std::nullopt, .body = text};
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::size_t behind = std::min(comma + 1, text.size());
  return {.hash = text.substr(kHash.size(), comma - kHash.size()), .body = text.substr(behind)};
}

}  // namespace

std::string HashOfRequest(std::string_view text) { return ChecksumOf(SealedTextOf(text).body); }

Expected<SurveyArea> AreaRequested(std::string_view text, const AreaSetting& setting) {
  const SealedText sealed = SealedTextOf(text);
  if (sealed.hash && *sealed.hash != ChecksumOf(sealed.body)) {
    return Error{"it came damaged: its hash is of another text"};
  }
  return RequestedArea(sealed.body, setting);
}

}  // namespace limpet
