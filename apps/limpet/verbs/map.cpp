// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/session_input.hpp"
#include "estimation/mapping/map_export.hpp"
#include "estimation/mapping/saved_map.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "estimation/scene/map_scene.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/core/config.hpp"
#include "limpet/map_files/ascii_grid.hpp"
#include "limpet/map_files/depth_grid.hpp"
#include "limpet/map_files/map_diff_report.hpp"
#include "limpet/map_files/map_info.hpp"
#include "limpet/map_files/object_files.hpp"
#include "limpet/packing/gzip_bytes.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSessionWords =
    "<session> is a session's run folder or the session folder in it.";

/// What a format is, and how a session becomes it. `main` goes to --out; a second file, if there is
/// one, stands beside it, its name with `suffix` before the extension.
struct MapFile {
  std::string main;
  std::string holds;  ///< of the main one, in words, e.g. `4 objects`
  std::string suffix{}, second{};
};
using MakeFile = MapFile (*)(const SavedSession&, const SemanticOctree&);
struct Format {
  const char* name;
  const char* meaning;
  MakeFile make;
};

std::string ObjectsHeld(const SavedSession& session) {
  return fmt::format("{} objects", session.memory.objects.opis.size());
}

/// `render` gives the file's text.
template <class Render>
MapFile MakeVoxels(const SavedSession& session, const SemanticOctree& octree,
                   const Render& render) {
  const OccupiedMap occupied = OccupiedOf(octree);
  return {.main = render(occupied),
          .holds = session.memory.map.empty()
                       ? std::string("the session kept no voxels")
                       : fmt::format("{} voxels of {:g} m", occupied.voxels.size(),
                                     occupied.resolution)};
}

MapFile MakeGeoJson(const SavedSession& session, const SemanticOctree&) {
  const std::optional<GeoPoint> datum = DatumOf(session.facts);
  if (!datum) {
    throw Refusal(
        fmt::format("{}: the mission said no LatOrigin and LongOrigin: nobody knows where "
                    "on earth its objects are; csv has them in metres",
                    session.folder.string()));
  }
  return {.main = ObjectsToGeoJson(session, *datum), .holds = ObjectsHeld(session)};
}

/// Throws ConfigError.
MapFile MakeDepths(const SavedSession& session, const SemanticOctree&) {
  const Expected<DepthGrid> grid = DepthGridOf(session.memory);
  if (!grid) {
    throw ConfigError(ConfigProblem{.where = {.file = session.folder.string(), .line = 0},
                                    .key = "",
                                    .text = grid.error().text});
  }
  if (grid->frame.rows == 0) throw Refusal("the session kept no depth of the seabed");
  std::vector<float> sigma_m = grid->sigma_m;
  for (float& sigma : sigma_m) {
    sigma = std::hypot(sigma, static_cast<float>(grid->zero_sigma_m));
  }
  const auto known =
      std::ranges::count_if(grid->down_m, [](float down_m) { return !std::isnan(down_m); });
  return {.main = ToAsciiGrid(*grid, grid->down_m),
          .holds = fmt::format("{} x {} cells of {:g} m, {} of them with a depth", grid->frame.rows,
                               grid->frame.columns, grid->frame.cell_m, known),
          .suffix = "_sigma",
          .second = ToAsciiGrid(*grid, sigma_m)};
}

constexpr std::array<Format, 5> kFormats{
    Format{"ot", "occupied voxels as a ColorOcTree, which octovis opens",
           [](const SavedSession& session, const SemanticOctree& octree) {
             return MakeVoxels(session, octree, ToColorOctree);
           }},
    Format{"ply", "occupied voxels as coloured points",
           [](const SavedSession& session, const SemanticOctree& octree) {
             return MakeVoxels(session, octree, ToPly);
           }},
    Format{"geojson", "objects and the survey area on WGS84", MakeGeoJson},
    Format{"csv", "objects as a table",
           [](const SavedSession& session, const SemanticOctree&) {
             return MapFile{.main = ObjectsToCsv(session), .holds = ObjectsHeld(session)};
           }},
    Format{"asc", "depth of the seabed as an Esri ASCII grid; its sigma in a second one",
           MakeDepths}};

std::string FormatWords() {
  std::string text;
  for (const Format& format : kFormats)
    text += fmt::format("  {:<8} {}\n", format.name, format.meaning);
  return text;
}

const Format& FormatNamed(const std::string& name) {
  std::vector<std::string> names;
  for (const Format& format : kFormats) {
    if (name == format.name) return format;
    names.emplace_back(format.name);
  }
  const std::string nearest = NearestWord(name, names);
  throw UsageError(fmt::format("--format: `{}` is no format{}; there are {}", name,
                               nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest),
                               fmt::join(names, ", ")));
}

Command ExportForm() {
  return {.name = "limpet map export",
          .words = "<session>",
          .about =
              "Writes the map of a saved session for other programs: --format and --out, or "
              "--3dscene for a scene that MRPT's SceneViewer3D opens, with the seabed's "
              "voxels, each object with the ellipsoid of its three sigmas in the colour of "
              "its status, and the vehicle's path.\n\n" +
              FormatWords() +
              "\nScenes, points and voxels have x east, y north, z up; csv and asc are in the "
              "session's frame, north and east of its origin, depth down. " +
              kSessionWords,
          .options = {{.names = "--format", .value = "FORMAT", .meaning = "one of the above"},
                      {.names = "--out", .value = "FILE", .meaning = "where it goes"},
                      {.names = "--3dscene",
                       .value = "FILE",
                       .meaning = "where the scene goes, e.g. map.3Dscene"},
                      {.names = "--force", .meaning = "write over an existing file"}},
          .more =
              "  limpet map export runs/table1-1/change --format geojson --out objects.geojson\n"
              "  limpet map export runs/table1-1/change --3dscene change.3Dscene",
          .takes = "one session and --format FORMAT --out FILE, or --3dscene FILE",
          .least_words = 1,
          .most_words = 1};
}

/// Throws ConfigError.
SemanticOctree OctreeOfSession(const SavedSession& session) {
  Expected<SemanticOctree> octree = OctreeOf(session.memory.map);
  if (!octree) {
    throw ConfigError(ConfigProblem{.where = {.file = session.folder.string(), .line = 0},
                                    .key = "map",
                                    .text = octree.error().text});
  }
  return *std::move(octree);
}

void WriteScene(const Arguments& given, const SavedSession& session, const SemanticOctree& octree) {
  std::vector<Eigen::Vector3d> path_W;
  for (const ObservedFrame& frame : session.memory.frames)
    path_W.push_back(frame.X_WB.p_WB);
  CommandOutput output(given.Find("3dscene"), given.Has("force"), given.positionals().front());
  output.Write(Gzip(ToScene(octree, session.memory.objects.opis, path_W)));
  output.Commit();
  fmt::print("{}: {} objects, path of {} poses{}\n", output.path().string(),
             session.memory.objects.opis.size(), path_W.size(),
             session.memory.map.empty() ? "; the session kept no voxels" : "");
}

fs::path Beside(const fs::path& file, const std::string& suffix) {
  return file.parent_path() / (file.stem().string() + suffix + file.extension().string());
}

void WriteFormat(const Arguments& given, const SavedSession& session,
                 const SemanticOctree& octree) {
  const MapFile made = FormatNamed(*given.Find("format")).make(session, octree);
  const std::string input = given.positionals().front();
  CommandOutput output(given.Find("out"), given.Has("force"), input);
  output.Write(made.main);
  if (!made.second.empty()) {
    const fs::path second = Beside(output.path(), made.suffix);
    CommandOutput beside(second.string(), given.Has("force"), input);
    beside.Write(made.second);
    beside.Commit();
    fmt::print("{}: their sigma\n", second.string());
  }
  output.Commit();
  fmt::print("{}: {}\n", output.path().string(), made.holds);
}

/// Throws ConfigError, Refusal, UsageError.
int Export(const Arguments& given) {
  const bool wants_file = given.Find("format") && given.Find("out");
  if (wants_file == given.Find("3dscene").has_value() ||
      given.Find("format").has_value() != given.Find("out").has_value()) {
    throw UsageError("map export takes --format FORMAT and --out FILE, or --3dscene FILE");
  }
  if (wants_file) static_cast<void>(FormatNamed(*given.Find("format")));
  const SavedSession session = OpenSession(given.positionals().front(), "the session");
  const SemanticOctree octree = OctreeOfSession(session);
  if (wants_file) {
    WriteFormat(given, session, octree);
  } else {
    WriteScene(given, session, octree);
  }
  return kOk;
}

Command InfoForm() {
  return {.name = "limpet map info",
          .words = "<session>",
          .about = std::string("What a saved session's map holds: its origin, area, voxels, depths "
                               "and objects. ") +
                   kSessionWords,
          .options = {{.names = "--json", .meaning = "for programs"}},
          .takes = "one session",
          .least_words = 1,
          .most_words = 1};
}

Command DiffForm() {
  return {.name = "limpet map diff",
          .words = "<session A> <session B>",
          .about =
              "What differs between the maps of two saved sessions: where the seabed is deeper "
              "or shallower in B than in A, beyond what both know it to, once what all depths "
              "differ by (tide, the sensor's zero) is taken off; and the objects as `limpet "
              "change` judges them. Places are in B's frame. A session is its run folder or "
              "the session folder in it.",
          .options = {{.names = "--json", .meaning = "for programs"}},
          .takes = "two sessions",
          .least_words = 2,
          .most_words = 2};
}

int Print(const Expected<std::string>& text, const std::string& session) {
  if (!text) {
    fmt::print(stderr, "{}: {}\n", session, text.error().text);
    return kFailed;
  }
  fmt::print("{}", *text);
  return kOk;
}

int Info(const Arguments& given) {
  const SavedSession session = OpenSession(given.positionals()[0], "the session");
  return Print(given.Has("json") ? MapInfoJson(session) : MapInfoText(session),
               given.positionals()[0]);
}

int Diff(const Arguments& given) {
  const SavedSession a = OpenSession(given.positionals()[0], "session A");
  const SavedSession b = OpenSession(given.positionals()[1], "session B");
  return Print(given.Has("json") ? MapDiffJson(a, b) : MapDiffText(a, b), "map diff");
}

void PrintMapHelp() {
  fmt::print(
      "usage: limpet map <command> <session> [options]\n\n"
      "  info       what a saved session's map holds\n"
      "  export     the map for other programs, from octovis to a GIS\n"
      "  diff       what differs between the maps of two sessions\n\n"
      "`limpet map <command> --help` says more.\n");
}

}  // namespace

int RunMap(std::span<const std::string> args) {
  if (args.empty() || args[0] == "--help" || args[0] == "-h") {
    PrintMapHelp();
    return args.empty() ? kUsage : kOk;
  }
  if (args[0] == "info") return RunCommand(InfoForm(), args.subspan(1), Info);
  if (args[0] == "export") return RunCommand(ExportForm(), args.subspan(1), Export);
  if (args[0] == "diff") return RunCommand(DiffForm(), args.subspan(1), Diff);
  const std::string nearest = NearestWord(args[0], {"info", "export", "diff"});
  throw UsageError(
      fmt::format("no command `map {}`{}; `limpet map --help` lists them", args[0],
                  nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
}

}  // namespace limpet
