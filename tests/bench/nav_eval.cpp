// SPDX-License-Identifier: MIT
// nav_eval [--windows|--missed|--markdown] <stream folder>...: errors and cost of the estimator on
// recorded streams with truth. --windows adds the errors per five minutes, --missed the boxes of
// objects that were not used; --markdown writes docs/navigation-results.md; --silent=FROM,TO takes
// the DVL's lock away meanwhile [s] and tells how far off the vehicle was taken to be.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>
#include <malloc.h>

#include "estimation/replay/replay.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/statistics.hpp"
#include "tests/bench/consistency.hpp"
#include "tests/support/batch_solver.hpp"
#include "tests/support/dropout.hpp"
#include "tests/support/trajectory_error.hpp"

namespace {

using namespace limpet;

double HeapKilobytes() { return static_cast<double>(mallinfo2().uordblks) / 1024.0; }

/// All that is measured of one stream.
struct Evaluation {
  std::string name;
  ReplayResult result;
  TrajectoryError smoothed, online, reckoned;
  LandmarkErrors objects;
  int boxes_used = 0;
  double total_s = 0.0;
  double kilobytes_per_node = 0.0;  ///< per node at 5 Hz, whatever the chain's own spacing
  double batch_cost = 0.0;

  [[nodiscard]] double UpdateMs(double share) const {
    return 1e3 * Quantile(result.update_s, share);
  }
};

Evaluation Evaluate(const std::string& folder, const SensorStream& stream,
                    const StreamTruth& truth) {
  Evaluation e;
  e.name = std::filesystem::path(folder).lexically_normal().filename();
  const NavigatorParams params = ParamsForStream(stream.meta);
  const double heap = HeapKilobytes();
  e.result = Replay(
      stream, params, [] { return ThreadTime().value(); },
      [&](const Navigator& n) {
        const double duration = n.Smoothed(n.node_count() - 1).front().t;
        e.kilobytes_per_node = (HeapKilobytes() - heap) / (5.0 * duration);
        ChainGraph graph = n.graph();
        e.batch_cost = SolveBatch(graph).cost;
      });
  // Once more for the total: reading the clock at every update would be an eighth of it.
  const auto no_clock = [] { return 0.0; };
  const double start = ThreadTime().value();
  double end = start;
  static_cast<void>(
      Replay(stream, params, no_clock, [&end](const Navigator&) { end = ThreadTime().value(); }));
  e.total_s = end - start;
  e.smoothed = ErrorOf(e.result.smoothed, truth);
  e.online = ErrorOf(e.result.online, truth);
  e.reckoned = ErrorOf(e.result.reckoned, truth);
  e.objects = ErrorsOf(e.result.landmarks, e.smoothed.alignment, truth);
  e.boxes_used = static_cast<int>(std::ranges::count_if(
      e.result.associations, [](const auto& a) { return a.landmark.has_value(); }));
  return e;
}

void Print(const Evaluation& e) {
  fmt::print("{}\n  nodes {}  boxes used {} of {}  looks taken out {}\n", e.name,
             e.result.smoothed.size(), e.boxes_used, e.result.associations.size(),
             e.result.counts.looks);
  fmt::print(
      "  aligned: reckoned (horizontal) {:.3f}  online {:.3f}  smoothed {:.3f} m;  absolute "
      "smoothed {:.3f} m\n",
      e.reckoned.aligned_horizontal, e.online.aligned, e.smoothed.aligned, e.smoothed.absolute);
  fmt::print(
      "  OPIs {}: aligned max {:.3f} mean {:.3f}, absolute max {:.3f} m; duplicates {}, false "
      "{}, missed {}\n",
      e.result.landmarks.size(), e.objects.aligned_max, e.objects.aligned_mean,
      e.objects.absolute_max, e.objects.duplicates, e.objects.false_ones, e.objects.missed.size());
  for (const auto& l : e.result.landmarks) {
    const Eigen::Vector3d p = e.smoothed.alignment.Apply(l.object.p_W);
    const Eigen::Matrix3d& cov_W = l.object.cov_W;
    fmt::print("    {} ({:.2f}, {:.2f}, {:.2f}) sd ({:.2f}, {:.2f}, {:.2f}) looks {} class {}\n",
               l.id, p.x(), p.y(), p.z(), std::sqrt(cov_W(0, 0)), std::sqrt(cov_W(1, 1)),
               std::sqrt(cov_W(2, 2)), l.detections, l.object.color);
  }
  fmt::print(
      "  update median {:.4f}  99 % {:.3f}  max {:.2f} ms; total {:.3f} s; {:.2f} kB per 5 Hz "
      "node\n"
      "  cost {:.2f}, batch {:.2f}; {} in {} rounds\n",
      e.UpdateMs(0.5), e.UpdateMs(0.99), e.UpdateMs(1.0), e.total_s, e.kilobytes_per_node,
      e.result.finish.cost, e.batch_cost, e.result.finish.reason, e.result.finish.iterations);
}

/// Aligned error in windows of five minutes: smoothed, and online under the same alignment.
void PrintWindows(const Evaluation& e, const StreamTruth& truth) {
  constexpr double kWindow = 300.0;
  const auto rms_in = [&](const std::vector<SmoothedPose>& poses, double start) {
    double sum = 0.0;
    int count = 0;
    for (const SmoothedPose& pose : poses) {
      if (pose.t >= start && pose.t < start + kWindow) {
        sum += (e.smoothed.alignment.Apply(pose.X_WB.p_WB) - truth.At(pose.t)).squaredNorm();
        ++count;
      }
    }
    return count > 0 ? std::sqrt(sum / count) : 0.0;
  };
  for (double start = 0.0; start < e.result.smoothed.back().t; start += kWindow) {
    fmt::print("    {:5.0f} s: smoothed {:.3f}  online {:.3f} m\n", start,
               rms_in(e.result.smoothed, start), rms_in(e.result.online, start));
  }
}

void PrintMissed(const Evaluation& e, const std::filesystem::path& folder) {
  std::map<std::pair<int, int>, int> shown;
  for (const auto& row : ReadTable(folder / "truth_det.csv.gz")) {
    shown[{static_cast<int>(row[0]), static_cast<int>(row[1])}] = static_cast<int>(row[2]);
  }
  for (const ReplayAssociation& a : e.result.associations) {
    const int id = shown[{a.frame, a.detection}];
    if (id >= 0 && !a.landmark) fmt::print("    frame {}: object {} not used\n", a.frame, id);
    if (id < 0 && a.landmark) fmt::print("    frame {}: false box used\n", a.frame);
  }
}

/// Interval from `FROM,TO`.
Interval IntervalOf(const std::string& text) {
  return {std::stod(text), std::stod(text.substr(text.find(',') + 1))};
}

void PrintDropout(const Evaluation& e, const Interval& silent, const StreamTruth& truth) {
  Consistency objects;
  for (const Landmark& landmark : e.result.landmarks) {
    objects.Add(landmark.object.p_W - TruthOf(landmark.object.p_W, e.smoothed.alignment, truth),
                landmark.object.cov_W);
  }
  fmt::print("{} silent {:.0f}..{:.0f} s: NEES of landmarks {:.2f}\n", e.name, silent.low,
             silent.high, objects.mean());
  for (const double t : {silent.middle(), silent.high, silent.high + 30.0}) {
    const PlaceError error = PlaceErrorAt(t, e.result, truth);
    fmt::print("  {:.0f} s: {:.2f} m off, {:.2f} claimed, NEES {:.2f}\n", t, error.off, error.sigma,
               error.nees);
  }
}

void PrintMarkdownHead() {
  fmt::print(
      "# Navigation on recorded streams\n\n"
      "What `limpet nav` makes of the three recorded sessions, against their truth. Both "
      "references "
      "are batch\noptima with associations from the truth, which ours has to find: the first of "
      "the "
      "paper's factors alone,\nthe second (extended) also corrects box centres for perspective, "
      "uses "
      "the whole axis of boxes cut by the\nborder, and takes a range from the size of boxes, as "
      "ours "
      "does. Aligned errors leave out what GPS and the\ninitial heading decide. Times are one "
      "thread's CPU time, of whatever machine this was made on.\nGenerated: `nav_eval --markdown "
      "<streams> > docs/navigation-results.md` (`tests/bench`).\n\n"
      "| stream | dead reckoning [m] | online [m] | smoothed [m] | reference [m] | extended [m] | "
      "objects: worst, mean [m] | doubled, false, missed |\n|---|---|---|---|---|---|---|---|\n");
}

void PrintMarkdown(const std::vector<Evaluation>& all) {
  // Aligned errors of the batch optima in the streams' README: of eq. (6), and extended.
  const std::map<std::string, std::string> references{{"a-table1-discovery", "0.078 | 0.064"},
                                                      {"b-table1-change", "0.049 | 0.036"},
                                                      {"c-rough-1h", "0.119 | 0.112"}};
  PrintMarkdownHead();
  for (const Evaluation& e : all) {
    const auto found = references.find(e.name);
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {} | {:.2f}, {:.2f} | {}, {}, {} |\n", e.name,
               e.reckoned.aligned_horizontal, e.online.aligned, e.smoothed.aligned,
               found == references.end() ? "- | -" : found->second, e.objects.aligned_max,
               e.objects.aligned_mean, e.objects.duplicates, e.objects.false_ones,
               e.objects.missed.size());
  }
  fmt::print(
      "\n| stream | poses | update: median, 99 %, max [ms] | total [s] | kB per 5 Hz node | final "
      "cost, batch minimum |\n|---|---|---|---|---|---|\n");
  for (const Evaluation& e : all) {
    fmt::print("| {} | {} | {:.3f}, {:.3f}, {:.2f} | {:.3f} | {:.2f} | {:.2f}, {:.2f} |\n", e.name,
               e.result.smoothed.size(), e.UpdateMs(0.5), e.UpdateMs(0.99), e.UpdateMs(1.0),
               e.total_s, e.kilobytes_per_node, e.result.finish.cost, e.batch_cost);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string option = argc > 1 && argv[1][0] == '-' ? argv[1] : "";
  std::vector<Evaluation> all;
  for (int i = option.empty() ? 1 : 2; i < argc; ++i) {
    const Expected<SensorStream> stream = LoadSensorStream(argv[i]);
    if (!stream) {
      fmt::print(stderr, "{}\n", stream.error().text);
      return 1;
    }
    const StreamTruth truth = LoadTruth(argv[i]);
    const std::string silent = option.starts_with("--silent=") ? option.substr(9) : "";
    const Interval span = silent.empty() ? Interval{.low = 0.0, .high = -1.0} : IntervalOf(silent);
    all.push_back(Evaluate(argv[i], WithoutVelocity(*stream, span), truth));
    if (!silent.empty()) PrintDropout(all.back(), span, truth);
    if (option != "--markdown" && silent.empty()) Print(all.back());
    if (option == "--windows") PrintWindows(all.back(), truth);
    if (option == "--missed") PrintMissed(all.back(), argv[i]);
  }
  if (option == "--markdown") PrintMarkdown(all);
  return 0;
}
