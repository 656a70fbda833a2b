// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/nav.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/nav_input.hpp"
#include "estimation/navigation/measurement_source.hpp"
#include "estimation/navigation/sensor_beliefs.hpp"
#include "estimation/navigation/source_block.hpp"
#include "estimation/replay/former_landmarks.hpp"
#include "estimation/replay/rawlog.hpp"
#include "estimation/replay/replay.hpp"
#include "estimation/replay/stream_meta.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/replay_output/replay_plot.hpp"
#include "limpet/replay_output/replay_summary.hpp"
#include "limpet/replay_output/replay_tables.hpp"
#include "limpet/safety/safety_rule.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command NavForm() {
  return {
      .name = "limpet nav",
      .words = "<stream folder | FILE.rawlog | recording of another vehicle>",
      .about =
          "Runs the estimator alone on a recorded sensor stream (a folder with meta.csv and "
          "stream.csv.gz, or a rawlog of MRPT) and writes online.csv, online_covariance.csv "
          "(of its places), smoothed.csv (with 1-sigmas of place and heading), states.csv (current "
          "and speed through the water, what "
          "sensors are off by), landmarks.csv, landmarks_covariance.csv, associations.csv and "
          "timing.json into DIR. Of a log of MOOS it makes a track from "
          "NAV_HEADING, NAV_SPEED and NAV_DEPTH and compares it with NAV_X and NAV_Y. With --check "
          "it estimates nothing, but says what a recording holds, what of it agrees and what "
          "lacks; topics of ROS (as `rostopic echo -p` writes them) can be checked only.",
      .options = {{.names = "--out",
                   .value = "DIR",
                   .meaning = "where the results go; needed but with --check"},
                  {.names = "--check",
                   .meaning = "print what the recording holds and what of it agrees: rates and "
                              "pauses, beams against velocity and altitude, what the gate for "
                              "velocities refuses, the path's length, what is missing"},
                  {.names = "--former",
                   .value = "DIR",
                   .meaning =
                       "where those of an earlier session are: its objects are "
                       "recognised, also if its frame lies up to 50 m and 60 degrees off, and "
                       "matches.csv says which they are"},
                  {.names = "--vehicle",
                   .value = "FILE",
                   .meaning = "the vehicle's sensors and camera by its file, e.g. "
                              "feelhippo.yaml; else as meta.csv says them, which a log of MOOS "
                              "does not have"},
                  {.names = "--sources",
                   .value = "TEXT",
                   .meaning = "further sensors that are heard, with their keys as pNav's block "
                              "has them, e.g. \"acoustic_fix, beacon_range; beacon_range_at_m = "
                              "10, 0, 20\"; their rows are the stream folder's sources.csv"},
                  {.names = "--rawlog",
                   .value = "FILE",
                   .meaning = "also write the stream as a rawlog, which MRPT's viewers open "
                              "and this command takes for the stream; docs/estimation.md "
                              "says what is in it"},
                  {.names = "--force", .meaning = "write over an existing rawlog"},
                  {.names = "--plot",
                   .meaning = "also draw error.svg (with 3-sigma bounds; against the smoothed "
                              "track, no truth is read) and map.svg"},
                  {.names = "--json",
                   .meaning = "print timing.json instead of the summary, or the check as "
                              "JSON"}},
      .takes = "one recording (a folder or a file), and --out DIR or --check",
      .least_words = 1,
      .most_words = 1};
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

struct ReplayParams {
  NavigatorParams navigator;
  ReplaySensors sensors;
};

/// Those that `--sources` names; the error says what is wrong with them.
Expected<SourceFeed::Sources> SourcesFor(const Arguments& given) {
  SourceFeed::Sources sources;
  try {
    for (auto& [name, factory] : ParseSources(given.Find("sources").value_or("none"))) {
      static_cast<void>(factory->Make());  // its own checks, before any work
      sources.emplace_back(name, std::move(factory));
    }
  } catch (const ConfigError& error) {
    return Error{error.what()};
  }
  return sources;
}

/// Somebody has taken the wrong file, or meta.csv is another vehicle's.
void SayContradictions(const Arguments& given, const StreamMeta& meta, const VehicleFile& vehicle) {
  const VehicleGeometry geometry{.image = vehicle.camera.pinhole(),
                                 .distortion = vehicle.camera.lens_distortion(),
                                 .dvl_B = vehicle.sensors.dvl.p_BD};
  for (const Contradiction& one : Contradictions(meta, geometry)) {
    fmt::print(stderr, "{}: its meta.csv says {} {}, but {} {}: the vehicle's file counts\n",
               given.positionals().front(), one.key, one.in_meta, *given.Find("vehicle"),
               one.in_vehicle);
  }
}

/// Parameters from the file that `--vehicle` names, or from meta.csv; the error says what it lacks.
Expected<ReplayParams> ParamsFor(const Arguments& given, const NavInput& input) {
  const SensorStream& stream = input.stream;
  if (const auto file = given.Find("vehicle")) {
    try {
      VehicleFile vehicle = LoadMissionVehicle(*file, fs::current_path());
      SayContradictions(given, stream.meta, vehicle);
      // A speed that navigation says is the vehicle's, not its DVL's.
      if (input.is_own_navigation) vehicle.sensors.dvl.p_BD.setZero();
      return ReplayParams{
          ParamsForVehicle(vehicle.params, vehicle.sensors, vehicle.camera.geometry(), stream.meta),
          {.attitude = BelievedAttitude(vehicle.sensors), .lens = vehicle.camera.lens()}};
    } catch (const ConfigError& error) {
      return Error{error.what()};
    }
  }
  if (const auto problem = MissingCamera(stream)) {
    const fs::path named = given.positionals().front();
    const fs::path meta = fs::is_directory(named) ? named / "meta.csv" : named;
    return Error{fmt::format("{}: {}", meta.string(), *problem)};
  }
  if (const std::vector<std::string>& unsaid = stream.meta.unsaid; !unsaid.empty()) {
    fmt::print(
        stderr,
        "{}: its meta.csv does not say {}: usual values are taken; --vehicle FILE says them\n",
        given.positionals().front(), fmt::join(unsaid, ", "));
  }
  const auto commands = std::ranges::count_if(stream.rows, [](const StreamRow& row) {
    return std::holds_alternative<ThrusterShares>(row);
  });
  if (commands > 0) {
    fmt::print(stderr,
               "{}: {} commands of the thrusters are not heard: what they push is not known; "
               "--vehicle FILE says it\n",
               given.positionals().front(), commands);
  }
  return ReplayParams{ParamsForStream(stream.meta), SensorsForStream(stream.meta)};
}

/// Throws Refusal.
void WriteRawlog(const Arguments& given, const SensorStream& stream) {
  const auto name = given.Find("rawlog");
  if (!name) return;
  CommandOutput output(name, given.Has("force"), given.positionals().front());
  const PackedRawlog rawlog = ToRawlog(stream);
  output.Write(rawlog.bytes);
  output.Commit();
  if (!stream.source_rows.empty()) {
    fmt::print(stderr, "{}: {} rows of further sensors left out: a rawlog does not carry them\n",
               *name, stream.source_rows.size());
  }
  if (rawlog.untimely_rows > 0) {
    fmt::print(stderr, "{}: {} rows left out: their times are none that a rawlog can hold\n", *name,
               rawlog.untimely_rows);
  }
}

void PrintLosses(const SensorStream& stream) {
  for (const std::string& loss : stream.left_out)
    fmt::print(stderr, "{}\n", loss);
  for (const std::string& doubt : stream.doubts)
    fmt::print(stderr, "{}\n", doubt);
  if (stream.cut) fmt::print(stderr, "{}; what comes before was used\n", *stream.cut);
}

struct Results {
  ReplayResult replay;
  std::vector<Eigen::Vector4d> smoothed_sigmas{};
  std::string timing{};
};

bool WriteResults(const Arguments& given, const Results& results, const FormerSession& former) {
  const ReplayResult& result = results.replay;
  const fs::path out = *given.Find("out");
  std::error_code error;
  fs::create_directories(out, error);
  const bool is_written =
      Write(out / "online.csv", PosesCsv(result.online)) &&
      Write(out / "online_covariance.csv",
            PlaceCovariancesCsv(result.online, result.online_covariance_W)) &&
      Write(out / "smoothed.csv", SmoothedCsv(result.smoothed, results.smoothed_sigmas)) &&
      Write(out / "states.csv", StatesCsv(result.states)) &&
      Write(out / "landmarks.csv", LandmarksCsv(result.landmarks)) &&
      Write(out / "landmarks_covariance.csv",
            LandmarkCovarianceCsv(result.landmarks, result.landmark_covariance)) &&
      (former.objects.empty() || Write(out / "matches.csv", MatchesCsv(result.landmarks))) &&
      Write(out / "associations.csv", AssociationsCsv(result.associations)) &&
      Write(out / "timing.json", results.timing);
  const std::string name = fs::path(given.positionals().front()).lexically_normal().filename();
  return is_written &&
         (!given.Has("plot") || (Write(out / "error.svg", NavErrorPlot(result, name)) &&
                                 Write(out / "map.svg", NavMapPlot(result, name))));
}

int ReplayStream(const Arguments& given) {
  if (given.Has("check")) return CheckRecording(given);
  if (!given.Has("out")) throw UsageError("nav takes " + NavForm().takes);
  const Expected<NavInput> input = LoadNavInput(given);
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().text);
    return kFailed;
  }
  const SensorStream& stream = input->stream;
  PrintLosses(stream);
  WriteRawlog(given, stream);
  Expected<ReplayParams> params = ParamsFor(given, *input);
  const Expected<SourceFeed::Sources> sources = SourcesFor(given);
  if (!params || !sources) {
    fmt::print(stderr, "{}\n", params ? sources.error().text : params.error().text);
    return kFailed;
  }
  params->sensors.sources = *sources;
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
  Results results;
  const auto take_sigmas = [&results](const Navigator& navigator) {
    results.smoothed_sigmas = navigator.SmoothedSigmas();
  };
  results.replay =
      Replay(stream, params->navigator, thread_time, take_sigmas, former, params->sensors);
  const ReplayResult& result = results.replay;
  results.timing = TimingJson(result.update_s, thread_time() - start);
  if (result.smoothed.empty()) {
    fmt::print(stderr, "{}: no pose could be estimated (no attitude)\n",
               given.positionals().front());
    return kFailed;
  }

  const bool is_written = WriteResults(given, results, former);
  if (given.Has("json")) {
    fmt::print("{}", results.timing);
  } else {
    const double doubtful = SafetyRuleOf(SafetyRuleId::kSigmaHigh).limit.value;
    fmt::print("{}{}", ReplaySummary(stream, result, former, doubtful),
               OwnTrackSummary(*input, result));
  }
  return is_written ? kOk : kFailed;
}

}  // namespace

int RunNav(std::span<const std::string> args) { return RunCommand(NavForm(), args, ReplayStream); }

}  // namespace limpet
