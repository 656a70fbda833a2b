// SPDX-License-Identifier: MIT
#include "limpet/report/lanes_sentence.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"

namespace limpet {
namespace {

std::optional<double> WayTo(const std::vector<CoverageLevel>& levels, double share) {
  const auto level = std::ranges::find(levels, share, &CoverageLevel::level);
  return level == levels.end() ? std::nullopt : level->path_m;
}

std::string MetresOrNever(const std::optional<double>& metres) {
  return metres ? fmt::format("{:.0f} m", *metres) : "never";
}

/// What the survey took of what lanes take.
std::string ShareText(const std::optional<double>& own, const std::optional<double>& lanes) {
  return own && lanes && *lanes > 0.0 ? fmt::format("{:.2f}", *own / *lanes) : "-";
}

std::string WinsText(const OptionWins& wins) {
  return fmt::format("{} {:.0f} m ({})", OneLine(wins.source, 20), wins.path_m, wins.decisions);
}

}  // namespace

std::string LanesSentence(const SessionScore& session) {
  if (!session.lanes) return "";
  const LanesScore& lanes = *session.lanes;
  const CoverageScore& own = session.coverage;
  const auto bottom = WayTo(lanes.seabed, 0.95), band = WayTo(lanes.band, 0.95);
  return fmt::format(
      "lanes: 95 % of bottom {}, of band {}, home {}; this survey {}, {}, {} of that",
      MetresOrNever(bottom), MetresOrNever(band), MetresOrNever(lanes.path_m),
      ShareText(WayTo(own.seabed, 0.95), bottom), ShareText(WayTo(own.band, 0.95), band),
      ShareText(session.survey_path_m, lanes.path_m));
}

std::string WinsSentence(const SessionScore& session) {
  constexpr std::size_t kNamed = 4;  // that it stays a line
  std::string out;
  OptionWins others{.source = "others"};
  for (std::size_t i = 0; i < session.wins.size(); ++i) {
    const OptionWins& wins = session.wins[i];
    if (i < kNamed) {
      out += (out.empty() ? "options flown (decisions): " : ", ") + WinsText(wins);
    } else {
      others.decisions += wins.decisions;
      others.path_m += wins.path_m;
    }
  }
  return others.decisions > 0 ? out + ", " + WinsText(others) : out;
}

}  // namespace limpet
