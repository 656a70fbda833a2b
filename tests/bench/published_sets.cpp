// SPDX-License-Identifier: MIT
// published_sets <folder>: published pose graphs and range sessions through the smoother, with the
// batch minimum and the error against the truth where that is known; docs/published-sets.md.
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/statistics.hpp"
#include "tests/support/published_run.hpp"

namespace {

using namespace limpet;

double Now() { return ThreadTime().value(); }

void PrintSet(const std::string& name, const SetResult& r, const std::string& error) {
  fmt::print(
      "| {} | {} | {} + {} | {:.4f} | {:.4f} | {:.4f} | {:.1e} | {} | {:.3f}, {:.2f}, {:.2f} | "
      "{:.1f}, {:.1f} | {} |\n",
      name, r.poses, r.landmarks, r.places, r.running_cost, r.cost, r.batch_cost, r.Excess(),
      r.finish.has_converged ? fmt::format("{}", r.finish.iterations) : "not converged",
      1e3 * Quantile(r.update_s, 0.5), 1e3 * Quantile(r.update_s, 0.99),
      1e3 * Quantile(r.update_s, 1.0), 1e3 * r.converge_s, 1e3 * r.batch_s, error);
}

bool PrintPlanar(const std::filesystem::path& file) {
  const Expected<PlanarGraph> graph = ReadPlanarGraph(file);
  if (!graph) {
    fmt::print(stderr, "{}\n", graph.error().text);
    return false;
  }
  PrintSet(file.filename().string(), RunPlanarGraph(*graph, Now), "no truth");
  return true;
}

bool PrintRanges(const std::filesystem::path& stem) {
  const Expected<RangeSession> session = ReadRangeSession(stem);
  if (!session) {
    fmt::print(stderr, "{}\n", session.error().text);
    return false;
  }
  for (const bool has_own_scale : {false, true}) {
    const SetResult result = RunRangeSession(*session, {.has_own_scale = has_own_scale}, Now);
    const SetError error = ErrorOfRangeSession(result, *session);
    PrintSet(fmt::format("{}{}", stem.filename().string(),
                         has_own_scale ? ", scale of each beacon's ranges estimated" : ""),
             result,
             fmt::format("{:.2f} m, beacons at worst {:.2f} m", error.poses, error.worst_beacon));
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "published_sets <folder>\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  fmt::print(
      "# Published sets through the smoother\n\n"
      "Pose graphs and a range session that others publish their solvers with, through the chain "
      "of "
      "poses with a\nborder, pose by pose, one update each, then `Converge`. The batch minimum is "
      "the "
      "lower of two batch solutions\nof the same factors: from the smoother's result, and from the "
      "file's own guess (Plaza 1: from the odometry, the\nbeacons at their true places). Times are "
      "one thread's CPU time on the machine that made this.\n"
      "Generated: `published_sets <folder> > docs/published-sets.md` (`tests/bench`).\n\n"
      "| set | poses | landmarks + places | cost running | cost converged | batch minimum | excess "
      "| rounds | update: median, 99 %, max [ms] | converge, batch [ms] | error |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  bool is_good = true;
  for (const char* name : {"w100.graph", "example.graph"})
    is_good = PrintPlanar(folder / name) && is_good;
  is_good = PrintRanges(folder / "Plaza1") && is_good;
  fmt::print(
      "\n- **Planar sets**: height, pitch and roll are held in the plane. An edge that skips poses "
      "goes "
      "through a *place*:\n  a block of the border, (x, y, yaw), tied to the earlier pose by 1 mm "
      "and "
      "1 mrad. Each place is three unknowns of\n  the dense root, so tens or a few hundred of them "
      "are cheap and thousands are not. EQUIV lines are counted and\n  not used: the edges say it "
      "already, with their own noise.\n"
      "- **Plaza 1**: ranges alone. A beacon comes in once least squares from sixteen starts agree "
      "on "
      "its place, and the\n  mirrored place of a straight way no longer fits; its earlier ranges "
      "come "
      "in with it. Its ranges are about 5 % too\n  long: with the scale as the third number of "
      "each "
      "beacon's block, the error falls to a third. Odometry: {} m and\n  {} rad per step of 0.2 s; "
      "ranges: {} m, Huber {}.\n"
      "- **Not run**: sphere2500, pose3example and toyExample.g2o, pose graphs in space. A closure "
      "there is six unknowns of\n  one pose against six of another; a term here knows one pose and "
      "one block of three. It could be split in two\n  terms on two blocks, but in sphere2500 "
      "every "
      "second edge is a closure and nearly every pose would be a place:\n  14 700 unknowns in a "
      "dense "
      "root. That is what general sparse solvers are for; this one is for a vehicle that\n  meets "
      "landmarks.\n",
      RangeSessionParams().way_sigma, RangeSessionParams().turn_sigma,
      RangeSessionParams().range_sigma, RangeSessionParams().huber);
  return is_good ? 0 : 1;
}
