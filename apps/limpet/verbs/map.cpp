// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/map.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "estimation/replay/gzip_bytes.hpp"
#include "estimation/scene/map_scene.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/core/config.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {
namespace {

Command ExportForm() {
  return {.name = "limpet map export",
          .words = "<session>",
          .about =
              "Writes the map of a saved session as a scene that MRPT's SceneViewer3D opens: the "
              "seabed's voxels, each object with the ellipsoid of its three sigmas in the colour "
              "of its status, and the vehicle's path. x is east, y north, z up. <session> is a "
              "session's run folder or the session folder in it.",
          .options = {{.names = "--3dscene",
                       .value = "FILE",
                       .meaning = "where the scene goes, e.g. map.3Dscene",
                       .is_required = true},
                      {.names = "--force", .meaning = "write over an existing file"}},
          .more =
              "The session's folder has the voxels as map.ply, map.csv and map_color.ot, too, "
              "in its folder export.\n\n"
              "  limpet map export runs/table1-1/change --3dscene change.3Dscene",
          .takes = "one session and --3dscene FILE",
          .least_words = 1,
          .most_words = 1};
}

/// Throws ConfigError, Refusal.
int Export(const Arguments& given) {
  const SavedSession session = LoadSavedSession(given.positionals().front(), "the session");
  Expected<SemanticOctree> octree =
      session.memory.map.empty() ? SemanticOctree() : SemanticOctree::Parse(session.memory.map);
  if (!octree) {
    fmt::print(stderr, "{}: map.ot: {}\n", given.positionals().front(), octree.error().text);
    return kFailed;
  }
  std::vector<Eigen::Vector3d> path_W;
  for (const ObservedFrame& frame : session.memory.frames)
    path_W.push_back(frame.X_WB.p_WB);
  CommandOutput output(given.Find("3dscene"), given.Has("force"), given.positionals().front());
  output.Write(Gzip(ToScene(*octree, session.memory.objects.opis, path_W)));
  output.Commit();
  fmt::print("{}: {} objects, path of {} poses{}\n", output.path().string(),
             session.memory.objects.opis.size(), path_W.size(),
             session.memory.map.empty() ? "; the session kept no voxels" : "");
  return kOk;
}

void PrintMapHelp() {
  fmt::print(
      "usage: limpet map export <session> --3dscene FILE\n\n"
      "  export     a scene of a saved session's map, for MRPT's SceneViewer3D\n\n"
      "`limpet map export --help` says more.\n");
}

}  // namespace

int RunMap(std::span<const std::string> args) {
  if (args.empty() || args[0] == "--help" || args[0] == "-h") {
    PrintMapHelp();
    return args.empty() ? kUsage : kOk;
  }
  if (args[0] != "export") {
    const std::string nearest = NearestWord(args[0], std::vector<std::string>{"export"});
    throw UsageError(
        fmt::format("no command `map {}`{}; `limpet map --help` lists them", args[0],
                    nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
  }
  return RunCommand(ExportForm(), args.subspan(1), Export);
}

}  // namespace limpet
