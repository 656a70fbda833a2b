// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/nav.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "estimation/replay/former_landmarks.hpp"
#include "estimation/replay/replay.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/replay_output/replay_plot.hpp"
#include "limpet/replay_output/replay_tables.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command NavForm() {
  return {.name = "limpet nav",
          .words = "<stream folder>",
          .about =
              "Runs the estimator alone on a recorded sensor stream (meta.csv and "
              "stream.csv.gz) and writes online.csv, smoothed.csv, states.csv (current and speed "
              "through the "
              "water), landmarks.csv, "
              "landmarks_covariance.csv, associations.csv and timing.json into DIR.",
          .options = {{.names = "--out",
                       .value = "DIR",
                       .meaning = "where the results go",
                       .is_required = true},
                      {.names = "--former",
                       .value = "DIR",
                       .meaning =
                           "where those of an earlier session are: its objects are "
                           "recognised, also if its frame lies up to 50 m and 60 degrees off, and "
                           "matches.csv says which they are"},
                      {.names = "--vehicle",
                       .value = "FILE",
                       .meaning = "the vehicle's sensors and camera by its file, e.g. "
                                  "feelhippo.yaml; else as meta.csv says them"},
                      {.names = "--plot",
                       .meaning = "also draw error.svg (with 3-sigma bounds; against the smoothed "
                                  "track, no truth is read) and map.svg"},
                      {.names = "--json", .meaning = "print timing.json instead of the summary"}},
          .takes = "one stream folder and --out DIR",
          .least_words = 1,
          .most_words = 1};
}

std::string FormerSummary(const ReplayResult& result, const FormerSession& former) {
  const auto matched = std::ranges::count_if(
      result.landmarks, [](const Landmark& landmark) { return landmark.former_id.has_value(); });
  const FrameOffset& offset = result.former_offset;
  return fmt::format(
      "former session: {} of {} objects recognised; its frame lies {:.2f} m north, {:.2f} m east, "
      "{:.2f} m down, turned by {:.2f} deg\n",
      matched, former.ids.size(), offset.shift.x(), offset.shift.y(), offset.down,
      Radians(offset.turn).in_text_unit());
}

bool Write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    fmt::print(stderr, "{}: cannot be written\n", file.string());
  }
  return static_cast<bool>(out);
}

/// Of the file that `--vehicle` names, or of meta.csv; the error says what it lacks.
Expected<NavigatorParams> ParamsFor(const Arguments& given, const SensorStream& stream) {
  if (const auto file = given.Find("vehicle")) {
    try {
      const VehicleFile vehicle = LoadMissionVehicle(*file, fs::current_path());
      return ParamsForVehicle(vehicle.sensors, vehicle.camera.geometry(), stream.meta);
    } catch (const ConfigError& error) {
      return Error{error.what()};
    }
  }
  if (const auto problem = MissingCamera(stream)) {
    const fs::path meta = fs::path(given.positionals().front()) / "meta.csv";
    return Error{fmt::format("{}: {}", meta.string(), *problem)};
  }
  return ParamsForStream(stream.meta);
}

int ReplayStream(const Arguments& given) {
  const Expected<SensorStream> stream = LoadSensorStream(given.positionals().front());
  if (!stream) {
    fmt::print(stderr, "{}\n", stream.error().text);
    return kFailed;
  }
  const Expected<NavigatorParams> params = ParamsFor(given, *stream);
  if (!params) {
    fmt::print(stderr, "{}\n", params.error().text);
    return kFailed;
  }
  FormerSession former;
  if (const auto folder = given.Find("former")) {
    Expected<FormerSession> loaded = LoadFormerLandmarks(*folder);
    if (!loaded) {
      fmt::print(stderr, "{}\n", loaded.error().text);
      return kFailed;
    }
    former = *std::move(loaded);
  }
  const auto thread_time = [] { return ThreadTime().value(); };
  const double start = thread_time();
  const ReplayResult result = Replay(*stream, *params, thread_time, {}, former);
  const std::string timing = TimingJson(result.update_s, thread_time() - start);
  if (result.smoothed.empty()) {
    fmt::print(stderr, "{}: no pose could be estimated (no attitude)\n",
               given.positionals().front());
    return kFailed;
  }

  const fs::path out = *given.Find("out");
  std::error_code error;
  fs::create_directories(out, error);
  const bool is_written =
      Write(out / "online.csv", PosesCsv(result.online)) &&
      Write(out / "smoothed.csv", PosesCsv(result.smoothed)) &&
      Write(out / "states.csv", StatesCsv(result.states)) &&
      Write(out / "landmarks.csv", LandmarksCsv(result.landmarks)) &&
      Write(out / "landmarks_covariance.csv",
            LandmarkCovarianceCsv(result.landmarks, result.landmark_covariance)) &&
      (former.ids.empty() || Write(out / "matches.csv", MatchesCsv(result.landmarks))) &&
      Write(out / "associations.csv", AssociationsCsv(result.associations)) &&
      Write(out / "timing.json", timing);
  const std::string name = fs::path(given.positionals().front()).lexically_normal().filename();
  const bool is_drawn =
      !given.Has("plot") || (Write(out / "error.svg", NavErrorPlot(result, name)) &&
                             Write(out / "map.svg", NavMapPlot(result, name)));
  if (stream->cut) {
    fmt::print(stderr, "{}; what comes before was used\n", *stream->cut);
  }
  if (given.Has("json")) {
    fmt::print("{}", timing);
  } else {
    fmt::print(
        "{} poses, {} landmarks; {}\nrefused: {} rows, {} velocities, {} depths, {} fixes, "
        "{} late frames\n",
        result.smoothed.size(), result.landmarks.size(), result.finish.reason,
        stream->refused_rows + result.counts.stale_samples, result.counts.velocities,
        result.counts.depths, result.counts.fixes, result.counts.late_frames);
    if (!former.ids.empty()) fmt::print("{}", FormerSummary(result, former));
  }
  return is_written && is_drawn ? kOk : kFailed;
}

}  // namespace

int RunNav(std::span<const std::string> args) { return RunCommand(NavForm(), args, ReplayStream); }

}  // namespace limpet
