// SPDX-License-Identifier: MIT
// nav_eval [--windows] <stream folder>...: errors and cost of the estimator on recorded streams
// with truth.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>
#include <time.h>

#include "estimation/replay/replay.hpp"
#include "tests/support/trajectory_error.hpp"

namespace {

double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double Quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.empty()
             ? 0.0
             : values[static_cast<std::size_t>(share * (static_cast<double>(values.size()) - 1.0))];
}

/// Aligned error in windows of five minutes: smoothed, and online under the same alignment.
void PrintWindows(const limpet::ReplayResult& result, const limpet::Alignment& alignment,
                  const limpet::StreamTruth& truth) {
  constexpr double kWindow = 300.0;
  const auto rms_in = [&](const std::vector<limpet::SmoothedPose>& poses, double start) {
    double sum = 0.0;
    int count = 0;
    for (const limpet::SmoothedPose& pose : poses) {
      if (pose.t >= start && pose.t < start + kWindow) {
        sum += (alignment.Apply(pose.X_WB.p_WB) - truth.At(pose.t)).squaredNorm();
        ++count;
      }
    }
    return count > 0 ? std::sqrt(sum / count) : 0.0;
  };
  for (double start = 0.0; start < result.smoothed.back().t; start += kWindow) {
    fmt::print("    {:5.0f} s: smoothed {:.3f}  online {:.3f} m\n", start,
               rms_in(result.smoothed, start), rms_in(result.online, start));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool prints_windows = argc > 1 && std::string(argv[1]) == "--windows";
  for (int i = prints_windows ? 2 : 1; i < argc; ++i) {
    const limpet::Expected<limpet::SensorStream> stream = limpet::LoadSensorStream(argv[i]);
    if (!stream) {
      fmt::print(stderr, "{}\n", stream.error().text);
      return 1;
    }
    const limpet::StreamTruth truth = limpet::LoadTruth(argv[i]);
    const double start = ThreadSeconds();
    const limpet::ReplayResult result =
        limpet::Replay(*stream, limpet::ParamsForStream(stream->meta), ThreadSeconds);
    const double total = ThreadSeconds() - start;
    const auto smoothed = ErrorOf(result.smoothed, truth), online = ErrorOf(result.online, truth);
    const auto reckoned = ErrorOf(result.reckoned, truth);
    const auto opis = ErrorsOf(result.landmarks, smoothed.alignment, truth);
    const int used = static_cast<int>(
        std::ranges::count_if(result.associations, [](const auto& a) { return a.landmark >= 0; }));
    std::map<std::pair<int, int>, int> shown;
    for (const auto& row : limpet::ReadTable(std::filesystem::path(argv[i]) / "truth_det.csv.gz")) {
      shown[{static_cast<int>(row[0]), static_cast<int>(row[1])}] = static_cast<int>(row[2]);
    }
    if (std::getenv("WIN"))
      for (const auto& a : result.associations) {
        const int id = shown[{a.frame, a.detection}];
        if (id >= 0 && a.landmark < 0)
          fmt::print("  t {:.0f} object {} not used\n", a.frame * 0.25, id);
      }
    fmt::print("{}\n  nodes {}  boxes used {} of {}  looks taken out {}\n", argv[i],
               result.smoothed.size(), used, result.associations.size(), result.counts.looks);
    fmt::print(
        "  aligned: reckoned (horizontal) {:.3f}  online {:.3f}  smoothed {:.3f} m;  absolute "
        "smoothed {:.3f} m\n",
        reckoned.aligned_horizontal, online.aligned, smoothed.aligned, smoothed.absolute);
    fmt::print(
        "  OPIs {}: aligned max {:.3f} mean {:.3f}, absolute max {:.3f} m; duplicates {}, false "
        "{}, missed {}\n",
        result.landmarks.size(), opis.aligned_max, opis.aligned_mean, opis.absolute_max,
        opis.duplicates, opis.false_ones, opis.missed.size());
    for (const auto& l : result.landmarks) {
      const Eigen::Vector3d p = smoothed.alignment.Apply(l.p);
      fmt::print("    {} ({:.2f}, {:.2f}, {:.2f}) sd ({:.2f}, {:.2f}, {:.2f}) looks {} class {}\n",
                 l.id, p.x(), p.y(), p.z(), std::sqrt(l.covariance(0, 0)),
                 std::sqrt(l.covariance(1, 1)), std::sqrt(l.covariance(2, 2)), l.looks, l.color);
    }
    if (prints_windows) PrintWindows(result, smoothed.alignment, truth);
    fmt::print(
        "  update median {:.4f}  99 % {:.3f}  max {:.2f} ms; total {:.2f} s; cost {:.1f}, {} in {} "
        "rounds\n",
        1e3 * Quantile(result.update_s, 0.5), 1e3 * Quantile(result.update_s, 0.99),
        1e3 * Quantile(result.update_s, 1.0), total, result.finish.cost, result.finish.reason,
        result.finish.iterations);
  }
  return 0;
}
