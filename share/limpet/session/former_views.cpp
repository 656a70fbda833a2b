// SPDX-License-Identifier: MIT
#include "limpet/session/former_views.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/four_decimals.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

/// How far apart the frames that a session hands on are at most, unless nothing was seen between
/// them: position [m], heading [rad]. What another look is, pMap's `new_look_distance_m` and
/// `new_look_angle_deg` say (LookParams), and whoever judges the former session counts its looks by
/// those of its mission, which are not known here. This is for the size of what is handed on alone,
/// and a shade finer than their defaults, so that none of those looks is lost.
constexpr double kViewDistance = 0.5;
constexpr double kViewTurn = 0.26;
constexpr std::string_view kPhasesHeader = "first_sight,phase";

/// A frame that may go on, and the last altitude heard until then.
struct View {
  const ObservedFrame* frame = nullptr;
  double altitude = 0.0;
  Seconds altitude_time;
};

/// Frames in which the session mapped; a vehicle that never heard an altitude saw nothing.
std::vector<View> MappingViews(const SessionMemory& memory) {
  const std::vector<std::string> phase_of = PhaseOfFrames(memory);
  std::vector<View> views;
  std::optional<double> altitude;
  Seconds altitude_time;
  for (std::size_t i = 0; i < memory.frames.size(); ++i) {
    const ObservedFrame& frame = memory.frames[i];
    if (frame.altitude) {
      altitude = frame.altitude;
      altitude_time = frame.exposure;
    }
    if (altitude && IsMappingPhase(phase_of[i])) {
      views.push_back({&frame, *altitude, altitude_time});
    }
  }
  return views;
}

bool IsOneLook(const ObservedFrame& a, const ObservedFrame& b) {
  return (a.X_WB.p_WB - b.X_WB.p_WB).norm() < kViewDistance &&
         std::abs(WrapAngle(a.X_WB.yaw - b.X_WB.yaw)) < kViewTurn;
}

bool IsListed(const Box& box, const std::vector<int>& landmarks) {
  return box.landmark.has_value() && std::ranges::find(landmarks, *box.landmark) != landmarks.end();
}

void AddView(const View& view, Seconds start, const std::vector<int>& landmarks,
             SessionPrior& prior) {
  const ObservedFrame& frame = *view.frame;
  const Pose& pose = frame.X_WB;
  FormerView former{
      .frame = {.frame = frame.frame,
                .exposure = Seconds(ToFourDecimals((frame.exposure - start).value())),
                .X_WB = {pose.p_WB.unaryExpr(&ToFourDecimals), ToFourDecimals(pose.roll),
                         ToFourDecimals(pose.pitch), ToFourDecimals(pose.yaw)},
                .altitude = ToFourDecimals(view.altitude)},
      .altitude_age = Seconds(ToFourDecimals((frame.exposure - view.altitude_time).value()))};
  for (const Box& box : frame.boxes) {
    if (IsListed(box, landmarks)) continue;
    former.frame.boxes.push_back(box);
    former.frame.boxes.back().landmark.reset();  // of none that is handed on
  }
  prior.views.push_back(std::move(former));
}

}  // namespace

void AddFormerViews(const SessionMemory& memory, const std::vector<int>& landmarks,
                    SessionPrior& prior) {
  const std::vector<View> views = MappingViews(memory);
  for (std::size_t first = 0, end = 0; first < views.size(); first = end) {
    bool has_stranger = false;
    for (end = first; end < views.size() && IsOneLook(*views[first].frame, *views[end].frame);
         ++end) {
      has_stranger = has_stranger ||
                     !std::ranges::all_of(views[end].frame->boxes,
                                          [&](const Box& box) { return IsListed(box, landmarks); });
    }
    const std::size_t kept = has_stranger ? end : first + 1;
    for (std::size_t i = first; i < kept; ++i) {
      AddView(views[i], memory.frames.front().exposure, landmarks, prior);
    }
  }
}

std::string PhasesToCsv(const std::vector<PhaseStart>& phases) {
  std::string text = std::string(kPhasesHeader) + "\n";
  for (const PhaseStart& start : phases) {
    std::string phase = start.phase;  // any client may announce one
    std::ranges::replace_if(
        phase, [](char c) { return c == ',' || c == '\n'; }, '_');
    text += fmt::format("{},{}\n", start.frame, phase);
  }
  return text;
}

Expected<std::vector<PhaseStart>> PhasesFromCsv(std::string_view text) {
  constexpr double kMostFrames = 1e9;
  std::vector<PhaseStart> phases;
  const std::vector<std::string> rows = Split(text, '\n');
  if (rows.front() != kPhasesHeader) {
    return Error{"line 1: not the header of a list of phases"};
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].empty()) continue;
    const std::vector<std::string> fields = Split(rows[i], ',');
    const std::optional<double> frame =
        fields.size() == 2 ? ParseNumber(fields[0]) : std::optional<double>();
    const double least = phases.empty() ? 0.0 : static_cast<double>(phases.back().frame);
    if (!frame || !(*frame >= least && *frame <= kMostFrames)) {
      return Error{fmt::format("line {}: not the start of a phase", i + 1)};
    }
    phases.push_back({static_cast<std::size_t>(*frame), fields[1]});
  }
  return phases;
}

}  // namespace limpet
