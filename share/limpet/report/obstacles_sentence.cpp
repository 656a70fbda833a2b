// SPDX-License-Identifier: MIT
#include "limpet/report/obstacles_sentence.hpp"

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"

namespace limpet {

std::string ObstaclesSentence(const SessionScore& session) {
  std::string text;
  for (const ObstacleScore& passed : session.obstacles) {
    text += text.empty() ? "obstacles passed at: " : ", ";
    text += passed.distance_m > 0.0
                ? fmt::format("{} {:.1f} m", OneLine(passed.name, 20), passed.distance_m)
                : fmt::format("{} TOUCHED", OneLine(passed.name, 20));
  }
  return text;
}

}  // namespace limpet
