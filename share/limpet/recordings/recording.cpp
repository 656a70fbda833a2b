// SPDX-License-Identifier: MIT
#include "limpet/recordings/recording.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

namespace limpet {
namespace {

template <class Row>
bool Holds(const SensorStream& stream) {
  return std::ranges::any_of(stream.rows,
                             [](const StreamRow& row) { return std::holds_alternative<Row>(row); });
}

}  // namespace

Recording RecordingOf(const SensorStream& stream, const std::string& name) {
  Recording recording{.name = name,
                      .pings = {},
                      .depths = {},
                      .own = {},
                      .missing = {},
                      .left_out = stream.left_out,
                      .doubts = stream.doubts};
  for (const StreamRow& row : stream.rows) {
    if (const auto* dvl = std::get_if<DvlRow>(&row)) {
      recording.pings.push_back({.t = dvl->t,
                                 .beam_speeds = {},
                                 .beam_ranges = dvl->beams,
                                 .v_D = dvl->v_WD_B,
                                 .altitude = dvl->altitude});
    } else if (const auto* depth = std::get_if<DepthReading>(&row)) {
      recording.depths.push_back(*depth);
    }
  }
  const auto lack = [&recording](const char* what, const char* cost) {
    recording.missing.push_back({.what = what, .reason = "no row says it", .cost = cost});
  };
  if (!Holds<AttitudeEstimate>(stream) && !Holds<InertialInput>(stream)) {
    lack("attitude and inertial samples", "no track can be reckoned");
  }
  if (recording.pings.empty()) lack("DVL", "no velocity: no track can be reckoned");
  if (recording.depths.empty()) lack("depth", "nothing tells the vehicle's depth");
  if (!Holds<FrameRow>(stream)) lack("camera frames", "no object can be placed");
  if (!Holds<PositionFix>(stream)) lack("position fixes", "the track counts from where it begins");
  if (stream.refused_rows > 0) {
    recording.left_out.push_back(
        fmt::format("{} rows that held a value that is no finite number", stream.refused_rows));
  }
  if (stream.cut) recording.left_out.push_back(*stream.cut + "; what comes before was used");
  return recording;
}

}  // namespace limpet
