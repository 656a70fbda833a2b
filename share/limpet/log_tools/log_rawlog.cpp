// SPDX-License-Identifier: MIT
// limpet log rawlog: what a run's sensors said, as a rawlog of MRPT.
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "estimation/replay/rawlog.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/log_tools/column_table.hpp"
#include "limpet/log_tools/log_commands.hpp"
#include "limpet/log_tools/log_input.hpp"
#include "limpet/log_tools/logged_stream.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

struct FlownVehicle {
  std::optional<VehicleFile> file;
  double object_radius_m = StreamMeta().opi_radius;
};

/// Vehicle of the mission that the session beside the log was flown with, as far as that is known.
FlownVehicle VehicleBeside(const fs::path& log) {
  FlownVehicle flown;
  try {
    const SavedSession session = LoadSavedSession(log.parent_path(), "the log's session");
    const auto& files = session.memory.mission;
    if (const auto block = BlockOf(session, "pNav")) {
      const ConfigEntry* radius = block->Find("opi_radius_m");
      if (radius != nullptr) flown.object_radius_m = ParseNumber(radius->value).value_or(0.0);
    }
    const auto mission = files.find(kMissionAsRun);
    if (mission == files.end()) return flown;
    const std::string named =
        ParseMission(mission->second, mission->first).Global(kVehicleFileGlobal);
    const auto vehicle = files.find(named);
    flown.file = vehicle != files.end() ? ParseVehicleFile(vehicle->second, named)
                                        : LoadMissionVehicle(named, log.parent_path());
  } catch (const ConfigError&) {  // a log alone, or of a session that is not whole
    return flown;
  }
  return flown;
}

/// Throws ConfigError if the file that is named cannot be read.
FlownVehicle VehicleFor(const Arguments& given, const fs::path& log) {
  FlownVehicle flown = VehicleBeside(log);
  if (const auto named = given.Find("vehicle")) {
    flown.file = LoadMissionVehicle(*named, fs::current_path());
  }
  return flown;
}

Command RawlogForm() {
  return {.name = "limpet log rawlog",
          .words = "<log>",
          .about =
              "Writes what the sensors of a run said (IMU_DATA, FOG_YAW_RATE, DVL_DATA, "
              "DEPTH_SENSOR, GPS_DATA, DETECTIONS) as a rawlog, which MRPT's viewers open and "
              "`limpet nav` replays. Images, commands of the thrusters and further sources stay "
              "in the log alone.",
          .options = {{.names = "--out",
                       .value = "FILE",
                       .meaning = "where the rawlog goes",
                       .is_required = true},
                      {.names = "--force", .meaning = "write over an existing file"},
                      {.names = "--vehicle",
                       .value = "FILE",
                       .meaning = "the vehicle's file, for camera and DVL; else that of the "
                                  "session saved beside the log"}},
          .more =
              "  limpet log rawlog runs/table1-1/discovery --out discovery.rawlog\n"
              "  limpet nav discovery.rawlog --vehicle feelhippo.yaml --out nav",
          .takes = "one log and --out FILE",
          .least_words = 1,
          .most_words = 1};
}

int RunRawlog(const Arguments& given) {
  LogInput input(given.positionals()[0]);
  CommandOutput output(given.Find("out"), given.Has("force"), input.file());
  const FlownVehicle flown = VehicleFor(given, input.file());
  LoggedStream logged(flown.file, flown.object_radius_m);
  AlogLine line;
  for (AlogEntry entry; input.Next(line, entry);) {
    if (line.kind != AlogLine::Kind::kEntry) continue;
    logged.Take(entry, input.reader().start().value_or(Seconds(0.0)).value());
  }
  input.PrintDoubts();
  if (logged.stream().rows.empty()) {
    fmt::print(stderr, "{}: holds no measurement of a sensor\n", input.file().string());
    return kFailed;
  }
  const PackedRawlog rawlog = ToRawlog(logged.stream());
  output.Write(rawlog.bytes);
  output.Commit();
  fmt::print("{}: {} measurements\n", output.path().string(),
             CountText(logged.stream().rows.size()));
  const std::size_t lost = logged.bad_entries() + static_cast<std::size_t>(rawlog.untimely_rows);
  if (lost > 0) fmt::print("  {} left out: they make no sense\n", CountText(lost));
  if (!flown.file) {
    fmt::print("  no vehicle is known: neither camera nor mounting of the DVL is in it\n");
  }
  return kOk;
}

}  // namespace

const LogCommand kLogRawlog{"rawlog", "the sensors' measurements as a rawlog of MRPT", RawlogForm,
                            RunRawlog};

}  // namespace limpet
