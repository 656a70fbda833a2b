// SPDX-License-Identifier: MIT
#include "limpet/report/fences_sentence.hpp"

#include <fmt/format.h>

namespace limpet {

std::string FencesSentence(const SessionScore& session) {
  constexpr double kSaid = 0.05;  // [m] what rounds to nothing is nothing
  if (!session.fences) return "";
  const FenceScore& fences = *session.fences;
  std::string text;
  if (fences.inside_zone_m >= kSaid) {
    text = fmt::format("ENTERED A KEEP-OUT ZONE, by {:.1f} m", fences.inside_zone_m);
  }
  if (fences.outside_region_m >= kSaid) {
    text += fmt::format("{}LEFT ITS REGION, by {:.1f} m", text.empty() ? "" : "; ",
                        fences.outside_region_m);
  }
  return text;
}

}  // namespace limpet
