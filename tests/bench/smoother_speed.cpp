// SPDX-License-Identifier: MIT
// smoother_speed: does an update stay as cheap as the session grows? Simulated sessions
// of 10 minutes to six hours over 4 and 50 objects: CPU time of one thread per update up to its
// published pose, and memory, with ratios to the first row and to a yardstick of the same run: the
// dense solve of the session's own root.
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <malloc.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/statistics.hpp"
#include "tests/support/simulated_stream.hpp"

namespace {

using namespace limpet;

constexpr double kNodesPerSecond = 5.0;  // of a chain that is not thinned

struct Row {
  int nodes_5hz = 0, poses = 0, landmarks = 0, border = 0;
  double median = 0.0, most = 0.0, worst = 0.0;  ///< of an update [ms]
  double total_s = 0.0, bytes = 0.0;             ///< per node at 5 Hz
  double yardstick_ms = 0.0;
};

double UsedBytes() { return static_cast<double>(mallinfo2().uordblks); }

/// Median time [ms] of factorising and solving a dense system of the size.
double DenseSolveMs(int size) {
  const Eigen::MatrixXd half = Eigen::MatrixXd::Random(size, size);
  const Eigen::MatrixXd A =
      half * half.transpose() + size * Eigen::MatrixXd::Identity(size, size).eval();
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(size);
  std::vector<double> times;
  double sum = 0.0;
  for (int i = 0; i < 101; ++i) {
    const double start = ThreadTime().value();
    sum += A.llt().solve(b).sum();
    times.push_back(1e3 * (ThreadTime().value() - start));
  }
  return sum == 0.0 ? 0.0 : Quantile(times, 0.5);  // the sum is used, so that it is computed
}

StreamScene SceneOf(int nodes_5hz, int objects) {
  StreamScene scene{.duration_s = nodes_5hz / kNodesPerSecond,
                    .half_size_m = objects > 10 ? 40.0 : 16.0,
                    .leg_spacing_m = 4.0,
                    .objects = objects,
                    .classes = objects > 10 ? 2 : 1,
                    .is_rough = objects > 10,
                    .tilt_deg = objects > 10 ? 0.0 : 30.0,
                    .altitude_m = objects > 10 ? 3.5 : 4.0,
                    .false_share = 0.3};
  scene.long_dropouts = static_cast<int>(scene.duration_s / 1800.0);
  return scene;
}

Row Measure(int nodes_5hz, int objects) {
  const SimulatedStream session = SimulateStream(SceneOf(nodes_5hz, objects));
  const NavigatorParams params = ParamsForStream(session.stream.meta);
  Row row{.nodes_5hz = nodes_5hz};
  const double before = UsedBytes();
  const ReplayResult result = Replay(
      session.stream, params, [] { return ThreadTime().value(); },
      [&](const Navigator& n) {
        row.bytes = (UsedBytes() - before) / nodes_5hz;
        row.poses = n.node_count();
        row.border = 3 * n.smoother().border_size();
      });
  row.landmarks = static_cast<int>(result.landmarks.size());
  row.median = 1e3 * Quantile(result.update_s, 0.5);
  row.most = 1e3 * Quantile(result.update_s, 0.99);
  row.worst = 1e3 * Quantile(result.update_s, 1.0);
  const double start = ThreadTime().value();
  static_cast<void>(Replay(session.stream, params, [] { return 0.0; }));
  row.total_s = ThreadTime().value() - start;
  row.yardstick_ms = DenseSolveMs(6 + row.border);
  return row;
}

std::string MachineLoad() {
  std::string load;
  std::getline(std::ifstream("/proc/loadavg"), load);
  return load.substr(0, load.find('/'));
}

void Print(const Row& row, const Row& first) {
  fmt::print(
      "| {} | {} | {} | {} | {:.4f} ({:.1f}) | {:.3f} ({:.1f}) | {:.2f} ({:.1f}) | {:.3f} | {:.0f} "
      "| "
      "{:.4f} | {:.2f}, {:.0f} |\n",
      row.nodes_5hz, row.poses, row.landmarks, row.border, row.median, row.median / first.median,
      row.most, row.most / first.most, row.worst, row.worst / first.worst, row.total_s, row.bytes,
      row.yardstick_ms, row.median / row.yardstick_ms, row.worst / row.yardstick_ms);
  std::fflush(stdout);
}

}  // namespace

int main() {
  fmt::print(
      "load {}\n\n"
      "| 5 Hz nodes | poses of the chain | landmarks | border | median [ms] (to first row) | 99 % "
      "[ms] | max [ms] | total [s] | bytes per 5 Hz node | dense root solve [ms] | median, max in "
      "root solves |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
      MachineLoad());
  for (const int objects : {4, 50}) {
    Row first;
    for (const int nodes : {3000, 10000, 30000, 110000}) {
      const Row row = Measure(nodes, objects);
      if (nodes == 3000) first = row;
      Print(row, first);
    }
  }
  fmt::print("\nload {}\n", MachineLoad());
  return 0;
}
