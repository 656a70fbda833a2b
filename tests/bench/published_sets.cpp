// SPDX-License-Identifier: MIT
// published_sets <folder>: published pose graphs and range sessions through the smoother, with the
// batch minimum and the error against the truth where that is known; a table in Markdown.
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "tests/support/published_run.hpp"
#include "tests/support/quantile.hpp"

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
      "| set | poses | landmarks + places | cost running | cost converged | batch minimum | excess "
      "| rounds | update: median, 99 %, max [ms] | converge, batch [ms] | error |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  bool is_good = true;
  for (const char* name : {"w100.graph", "example.graph"})
    is_good = PrintPlanar(folder / name) && is_good;
  return PrintRanges(folder / "Plaza1") && is_good ? 0 : 1;
}
