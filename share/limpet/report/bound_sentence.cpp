// SPDX-License-Identifier: MIT
#include "limpet/report/bound_sentence.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr double kLeastShare = 5e-4;  // that one decimal of a percent shows

const char* WordsOf(WhyUnseen why) {
  switch (why) {
    case WhyUnseen::kZone:
      return "behind a zone";
    case WhyUnseen::kClearance:
      return "out of sight of the region";
    case WhyUnseen::kTurn:
      return "narrower than a turn";
    case WhyUnseen::kTooFewLooks:
      return "too few looks";
    case WhyUnseen::kObstacle:
      return "under or behind obstacles";
    case WhyUnseen::kNotReached:
      break;
  }
  return "not reached";
}

}  // namespace

std::string BoundSentence(const SessionScore& session) {
  const auto least = session.bound ? session.bound->path_m() : std::nullopt;
  if (!least) return "";
  std::string out = fmt::format("least way {:.0f} m, {:.0f} m2 over a swath of {:.2f} m", *least,
                                session.bound->area_m2, session.bound->swath_m);
  const std::vector<CoverageLevel>& band = session.coverage.band;
  const auto level = std::ranges::find(band, 0.95, &CoverageLevel::level);
  if (level != band.end() && level->path_m && *least > 0.0) {
    out += fmt::format("; 95 % of the band took {:.2f} of it, {:.0f} s", *level->path_m / *least,
                       level->time_s.value_or(0.0));
  }
  return out;
}

std::string UnseenSentence(const UnseenScore& unseen) {
  std::string out;
  for (std::size_t i = 0; i < kWaysUnseen; ++i) {
    if (unseen.band_by_reason[i] < kLeastShare) continue;
    out += fmt::format("{}{} {:.1f} %", out.empty() ? "not seen of the band: " : ", ",
                       WordsOf(static_cast<WhyUnseen>(i)), 100.0 * unseen.band_by_reason[i]);
  }
  return out;
}

}  // namespace limpet
