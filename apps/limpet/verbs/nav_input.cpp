// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/nav_input.hpp"

#include <filesystem>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "estimation/replay/clock_steps.hpp"
#include "estimation/replay/rawlog.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/recordings/check_text.hpp"
#include "limpet/recordings/moos_log.hpp"
#include "limpet/recordings/own_track.hpp"
#include "limpet/recordings/recording_check.hpp"
#include "limpet/recordings/ros_csv.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// pLogger's other files (.slog, .ylog, ._moos) begin as an .alog does.
bool IsOtherLoggerFile(const fs::path& named) {
  std::ifstream in(named, std::ios::binary);
  return in.get() == '%' && in.get() == '%';
}

Expected<SensorStream> LoadStream(const fs::path& named) {
  std::error_code error;
  if (fs::is_regular_file(named, error) && IsOtherLoggerFile(named)) {
    return Error{named.string() +
                 ": is a file of a logger of MOOS, but not the .alog with its entries (time, "
                 "variable, source, value): name that"};
  }
  Expected<SensorStream> stream =
      fs::is_regular_file(named, error) ? LoadRawlog(named) : LoadSensorStream(named);
  if (stream) TakeOutClockSteps(named.string(), *stream);
  return stream;
}

Expected<Recording> LoadRecording(const fs::path& named) {
  if (IsRosRecording(named)) return LoadRosRecording(named);
  if (IsMoosRecording(named)) return LoadMoosRecording(named);
  const Expected<SensorStream> stream = LoadStream(named);
  if (!stream) return stream.error();
  return RecordingOf(*stream, named.string());
}

Refusal NoTrack(const fs::path& named, const Recording& recording) {
  return Refusal(
      fmt::format("{0}: no track can be reckoned from it; missing are\n{1}"
                  "`limpet nav {0} --check` says what it holds and what of it agrees",
                  named.string(), MissingText(recording)));
}

/// A track from what a vehicle's own navigation said, with everything that had to be assumed.
Expected<NavInput> TrackOf(const Arguments& given, const Recording& recording) {
  const fs::path named = given.positionals().front();
  const auto file = given.Find("vehicle");
  if (!file) {
    throw Refusal(
        fmt::format("{}: does not say its sensors' noise; --vehicle FILE does", named.string()));
  }
  const VehicleFile vehicle = LoadMissionVehicle(*file, fs::current_path());
  Expected<SensorStream> stream = StreamOf(recording, vehicle.sensors.imu.heading_sigma);
  if (!stream) throw NoTrack(named, recording);
  stream->left_out = recording.left_out;
  stream->left_out.push_back(fmt::format(
      "{}: a level vehicle was assumed that goes ahead at NAV_SPEED, with the noise of the "
      "vehicle's file; missing are\n{}",
      named.string(), MissingText(recording)));
  stream->left_out.back().pop_back();  // the last end of line
  return NavInput{
      .stream = *std::move(stream), .is_own_navigation = true, .own_places = recording.own.places};
}

}  // namespace

Expected<NavInput> LoadNavInput(const Arguments& given) {
  const fs::path named = given.positionals().front();
  if (!IsRosRecording(named) && !IsMoosRecording(named)) {
    Expected<SensorStream> stream = LoadStream(named);
    if (!stream) return stream.error();
    return NavInput{.stream = *std::move(stream), .is_own_navigation = false, .own_places = {}};
  }
  const Expected<Recording> recording = LoadRecording(named);
  if (!recording) return recording.error();
  if (recording->own.headings.empty() || recording->own.speeds.empty()) {
    throw NoTrack(named, *recording);
  }
  return TrackOf(given, *recording);
}

std::string OwnTrackSummary(const NavInput& input, const ReplayResult& result) {
  if (input.own_places.empty()) return "";
  const TrackDifference found = CompareTracks(result.smoothed, input.own_places);
  return fmt::format(
      "against the recording's own places: {:.1f} m off at the end, at most {:.1f} "
      "m, of a path of {:.1f} m\n",
      found.at_end, found.greatest, found.path);
}

int CheckRecording(const Arguments& given) {
  for (const char* other : {"out", "former", "vehicle", "rawlog", "plot"}) {
    if (given.Has(other)) throw UsageError(fmt::format("--check takes no --{}", other));
  }
  const fs::path named = given.positionals().front();
  const Expected<Recording> recording = LoadRecording(named);
  if (!recording) {
    fmt::print(stderr, "{}\n", recording.error().text);
    return kFailed;
  }
  const RecordingCheck check = Check(*recording);
  fmt::print("{}", given.Has("json") ? CheckJson(*recording, check) : CheckText(*recording, check));
  return kOk;
}

}  // namespace limpet
