// SPDX-License-Identifier: MIT
#include "limpet/report/phase_sentence.hpp"

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"

namespace limpet {

std::string PhaseSentence(const SessionScore& session) {
  std::string out;
  for (const PhaseTime& phase : session.phases) {
    out += fmt::format("{}{} {:.0f}", out.empty() ? "" : ", ", OneLine(phase.phase, 12),
                       phase.seconds);
  }
  return out;
}

}  // namespace limpet
