// SPDX-License-Identifier: MIT
#include "limpet/replay_output/replay_summary.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/harmless_text.hpp"
#include "limpet/replay_output/place_doubt.hpp"

namespace limpet {
namespace {

std::string FormerSummary(const ReplayResult& result, const FormerSession& former) {
  const auto matched = std::ranges::count_if(
      result.landmarks, [](const Landmark& landmark) { return landmark.former.id.has_value(); });
  const FrameOffset& offset = result.former_offset;
  return fmt::format(
      "former session: {} of {} objects recognised; its frame lies {:.2f} m north, {:.2f} m east, "
      "{:.2f} m down, turned by {:.2f} deg\n",
      matched, former.objects.size(), offset.shift_W.x(), offset.shift_W.y(), offset.down,
      Radians(offset.turn).in_text_unit());
}

/// What became of the rows of further sensors: also of those that nobody heard.
std::string SourcesSummary(const SourceUse& use) {
  std::string text;
  for (const ReplayedSource& one : use.sources) {
    if (one.heard == 0) {
      text += fmt::format("{}: no row of {}\n", one.name, one.variable);
      continue;
    }
    text += fmt::format(
        "{}: {} rows of {}; {} taken, {} refused, {} late, {} unused, {} that make no sense\n",
        one.name, one.heard, one.variable, one.counts.taken, one.counts.refused, one.counts.late,
        one.counts.unused, one.senseless);
  }
  for (const auto& [variable, rows] : use.unheard) {
    text += fmt::format("{} rows of {} were not used: no source of --sources hears it\n", rows,
                        HarmlessText(variable));
  }
  if (use.after_end > 0) {
    text += fmt::format("{} rows of further sensors lie after the stream's end\n", use.after_end);
  }
  return text;
}

/// What the estimate itself says that it does not know.
std::string DoubtSummary(const ReplayResult& result, double doubtful) {
  std::string text;
  if (!result.has_fix)
    text += "no GPS fix was used: places count from the start, taken for the origin\n";
  if (result.fix_error && result.fix_error->is_too_large()) {
    text += fmt::format(
        "fixes wander {:.1f} times as far as they state: they are believed as far as they show\n",
        result.fix_error->mean);
  }
  if (result.surface_reading) {
    text += fmt::format(
        "the depth sensor read {:.1f} m where fixes came, and no antenna is out of the water "
        "there: "
        "it was not zeroed, or tells the absolute pressure; all depths are off by that\n",
        *result.surface_reading);
  }
  for (const Disagreement& one : result.disagreements)
    text += one.text + "\n";
  for (const UnplacedObject& one : result.unplaced) {
    text += fmt::format(
        "{} boxes ({}) showed something near north {:.0f}, east {:.0f}, and agreed in no place\n",
        one.boxes, one.color, one.p_W.x(), one.p_W.y());
  }
  if (const auto doubt = WorstDoubt(result, doubtful)) {
    text += fmt::format(
        "the place was known to no better than {} m (1-sigma) for {:.0f} s, at worst to {:.0f} m "
        "at {:.0f} s\n",
        doubtful, doubt->seconds, doubt->sigma, doubt->t);
  }
  return text;
}

}  // namespace

std::string ReplaySummary(const SensorStream& stream, const ReplayResult& result,
                          const FormerSession& former, double doubtful) {
  std::string text = fmt::format(
      "{} poses, {} landmarks; {}\nrefused: {} rows, {} velocities, {} depths, {} fixes, "
      "{} late frames\n",
      result.smoothed.size(), result.landmarks.size(), result.finish.reason,
      stream.refused_rows + result.counts.stale_samples, result.counts.velocities,
      result.counts.depths, result.counts.fixes, result.counts.late_frames);
  if (stream.datum) {
    text += fmt::format("north and east count from the first fix, {:.7f}, {:.7f}\n",
                        stream.datum->latitude_deg, stream.datum->longitude_deg);
  }
  text += DoubtSummary(result, doubtful);
  if (!former.objects.empty()) text += FormerSummary(result, former);
  return text + SourcesSummary(result.sources);
}

}  // namespace limpet
