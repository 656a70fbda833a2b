// SPDX-License-Identifier: MIT
// nav_study [--scene NAME] [--seed FIRST] [--seeds N] [--oracle]
// [--former] [--details]: the estimator on simulated sessions, one line each, and their summary
// with NEES and update times. --oracle adds what a detector without mistakes would give; --former
// gives each session what an earlier one over the same place left: since then an eighth of the
// objects are gone, and as many came (--changed SHARE: another share; --another: nothing of it is
// here); --shift M and --turn DEG put that earlier one into a frame of its own, so far off at most,
// and count how many objects are recognised. --silent FROM,TO takes the DVL's lock away from one
// time [s] to another, and tells how far off the vehicle was taken to be at its end and 30 s after;
// --standing FROM,TO has the vehicle stand meanwhile. --fixes FACTOR has fixes wander by so much
// more than they state.
// --markdown writes docs/navigation-honesty.md, --errors its last table alone, both with a line per
// session on the error output.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/statistics.hpp"
#include "tests/bench/consistency.hpp"
#include "tests/bench/earlier_session.hpp"
#include "tests/bench/error_scenes.hpp"
#include "tests/bench/honesty_page.hpp"
#include "tests/bench/study_scenes.hpp"
#include "tests/support/dropout.hpp"
#include "tests/support/simulated_stream.hpp"

namespace {

using namespace limpet;

/// The same session seen by a detector that makes no mistakes: no false boxes, and a class of its
/// own for every object.
SensorStream WithTrueAssociations(const SimulatedStream& session) {
  SensorStream stream = session.stream;
  for (StreamRow& row : stream.rows) {
    if (auto* frame = std::get_if<FrameRow>(&row)) {
      std::vector<Box> boxes;
      for (int i = 0; i < static_cast<int>(frame->frame.boxes.size()); ++i) {
        const auto shown = session.shown.find({frame->frame.frame, i});
        if (shown == session.shown.end()) continue;
        boxes.push_back(frame->frame.boxes[static_cast<std::size_t>(i)]);
        boxes.back().color = fmt::format("object{}", shown->second);
      }
      frame->frame.boxes = boxes;
    }
  }
  return stream;
}

struct Associations {
  int wrong = 0, right = 0, missed = 0;
};
Associations AssociationsOf(const ReplayResult& result, const SimulatedStream& session) {
  // A landmark is the object that most of its boxes show.
  std::map<std::optional<int>, std::map<int, int>> votes;
  const auto shown_by = [&](const ReplayAssociation& a) {
    const auto shown = session.shown.find({a.frame, a.detection});
    return shown == session.shown.end() ? -1 : shown->second;
  };
  for (const ReplayAssociation& a : result.associations)
    ++votes[a.landmark][shown_by(a)];
  Associations out;
  for (const ReplayAssociation& a : result.associations) {
    const int shown = shown_by(a);
    if (!a.landmark) {
      out.missed += shown >= 0 ? 1 : 0;
      continue;
    }
    const auto most = std::ranges::max_element(votes[a.landmark], {},
                                               [](const auto& vote) { return vote.second; });
    (shown >= 0 && shown == most->first ? out.right : out.wrong) += 1;
  }
  return out;
}

struct Outcome {
  Eigen::Vector3d axes_pose = Eigen::Vector3d::Zero(), axes_landmark = axes_pose,
                  axes_between = axes_pose;
  double smoothed = 0.0, reckoned = 0.0, nees_pose = 0.0, nees_landmark = 0.0, nees_between = 0.0;
  int duplicates = 0, false_ones = 0, missed = 0, wrong = 0;
  Recognition recognition{};
  std::vector<double> update_s;
  std::vector<PlaceError> dropouts;  ///< amid, at the end of, and after what was silenced
};

/// Times of the sightings in a row of times of looks, and how many looks each has.
std::string SightingsOf(const std::vector<double>& times) {
  constexpr double kGap = 20.0;  // [s] between two sightings
  std::string text;
  for (std::size_t i = 0; i < times.size();) {
    std::size_t end = i + 1;
    while (end < times.size() && times[end] - times[end - 1] < kGap)
      ++end;
    text += fmt::format(" {:.0f} s x{}", times[i], end - i);
    i = end;
  }
  return text;
}

/// Dropouts, and what each landmark's boxes show.
void PrintDetails(const SimulatedStream& session, const ReplayResult& result,
                  const Alignment& alignment) {
  double last = 0.0;
  for (const StreamRow& row : session.stream.rows) {
    const auto* dvl = std::get_if<DvlRow>(&row);
    if (dvl == nullptr || !dvl->v_WD_B) continue;
    if (dvl->t - last > 10.0) fmt::print("  dropout {:.0f} .. {:.0f} s\n", last, dvl->t);
    last = dvl->t;
  }
  std::map<std::optional<int>, std::map<int, std::vector<double>>> looks;
  for (const ReplayAssociation& a : result.associations) {
    const auto shown = session.shown.find({a.frame, a.detection});
    looks[a.landmark][shown == session.shown.end() ? -1 : shown->second].push_back(0.25 * a.frame);
  }
  for (const Landmark& l : result.landmarks) {
    const Eigen::Vector3d p = alignment.Apply(l.object.p_W);
    fmt::print("  landmark {} class {} at ({:.2f} {:.2f} {:.2f})", l.id, l.object.color, p.x(),
               p.y(), p.z());
    for (const auto& [id, times] : looks[l.id]) {
      const auto object = std::ranges::find(session.truth.landmarks, id, &TrueLandmark::id);
      const double off = object == session.truth.landmarks.end() ? 0.0 : (p - object->p).norm();
      fmt::print("; object {} ({:.2f} m off):{}", id, off, SightingsOf(times));
    }
    fmt::print("\n");
  }
  for (const auto& [id, times] : looks[std::nullopt])
    if (id >= 0) fmt::print("  no landmark's: object {}:{}\n", id, SightingsOf(times));
}

struct Options {
  std::string scene = "table1";
  int first = 1, count = 5;
  bool has_oracle = false, has_details = false, has_former = false, is_markdown = false;
  FormerFrame former_frame{};
  std::optional<Interval> silent{}, standing{};
  double fix_error = 1.0;
};

/// Of the vehicle's place at the end of what was silenced, as told just before and 30 s after.
void PrintDropout(const Interval& silent, const ReplayResult& result, const StreamTruth& truth,
                  Outcome& outcome) {
  for (const double t : {silent.middle(), silent.high, silent.high + 30.0}) {
    const PlaceError error = PlaceErrorAt(t, result, truth);
    fmt::print("  {:.0f} s: {:.2f} m off, {:.2f} claimed, NEES {:.2f}", t, error.off, error.sigma,
               error.nees);
    outcome.dropouts.push_back(error);
  }
  fmt::print("\n");
}

/// Interval from `FROM,TO`.
Interval IntervalOf(const std::string& text) {
  return {std::stod(text), std::stod(text.substr(text.find(',') + 1))};
}

Outcome PrintSession(const SimulatedStream& session, const EarlierSession& earlier, int seed,
                     const Options& options) {
  const double start = ThreadTime().value();
  Consistency between;
  const ReplayResult result = Replay(
      session.stream, ParamsForStream(session.stream.meta), [] { return ThreadTime().value(); },
      [&](const Navigator& n) { between = ConsistencyBetween(n, session.truth); }, earlier.former);
  const double total = ThreadTime().value() - start;
  const auto smoothed = ErrorOf(result.smoothed, session.truth);
  const auto online = ErrorOf(result.online, session.truth);
  const auto reckoned = ErrorOf(result.reckoned, session.truth);
  const auto opis = ErrorsOf(result.landmarks, smoothed.alignment, session.truth);
  const Associations associations = AssociationsOf(result, session);
  Nees nees = NeesOf(result, session.truth);
  nees.between = between;
  std::FILE* out = options.is_markdown ? stderr : stdout;
  fmt::print(
      out,
      "{:4d} {:6d} | {:6.3f} {:6.3f} {:6.3f} {:6.3f} | {:3d} {:2d} {:2d} {:2d} {:5.2f} {:5.2f} | "
      "{:5d} "
      "{:4d} {:4d} | {:5.1f} {:5.1f} {:5.1f} | {:.4f} {:6.3f} {:7.2f} {:6.2f} | {}",
      seed, result.smoothed.size(), reckoned.aligned_horizontal, online.aligned, smoothed.aligned,
      smoothed.absolute, result.landmarks.size(), opis.duplicates, opis.false_ones,
      opis.missed.size(), opis.aligned_max, opis.aligned_mean, associations.right,
      associations.wrong, associations.missed, nees.pose.mean(), nees.landmark.mean(),
      nees.between.mean(), 1e3 * Quantile(result.update_s, 0.5),
      1e3 * Quantile(result.update_s, 0.99), 1e3 * Quantile(result.update_s, 1.0), total,
      result.finish.has_converged ? "" : "NOT CONVERGED");
  if (options.has_oracle) {
    const ReplayResult oracle = Replay(WithTrueAssociations(session),
                                       ParamsForStream(session.stream.meta), [] { return 0.0; });
    const auto truth_smoothed = ErrorOf(oracle.smoothed, session.truth);
    fmt::print(out, " ids {:.3f} missed {}", truth_smoothed.aligned,
               ErrorsOf(oracle.landmarks, truth_smoothed.alignment, session.truth).missed.size());
  }
  const Recognition recognition = RecognitionOf(result, earlier, session.truth, smoothed.alignment);
  if (options.has_former) {
    fmt::print(out, " known again {} of {}, wrongly {}", recognition.right, recognition.possible,
               recognition.wrong);
  }
  fmt::print(out, "\n");
  Outcome outcome{.axes_pose = nees.pose.axes(),
                  .axes_landmark = nees.landmark.axes(),
                  .axes_between = nees.between.axes(),
                  .smoothed = smoothed.aligned,
                  .reckoned = reckoned.aligned_horizontal,
                  .nees_pose = nees.pose.mean(),
                  .nees_landmark = nees.landmark.mean(),
                  .nees_between = nees.between.mean(),
                  .duplicates = opis.duplicates,
                  .false_ones = opis.false_ones,
                  .missed = static_cast<int>(opis.missed.size()),
                  .wrong = associations.wrong,
                  .recognition = recognition,
                  .update_s = result.update_s,
                  .dropouts = {}};
  if (options.silent) PrintDropout(*options.silent, result, session.truth, outcome);
  if (options.has_details) PrintDetails(session, result, smoothed.alignment);
  return outcome;
}

/// Means of the sessions' figures, sums of their counts, all their updates.
Outcome Together(const std::vector<Outcome>& all) {
  const auto n = static_cast<double>(all.size());
  Outcome sum;
  for (const Outcome& o : all) {
    sum.axes_pose += o.axes_pose / n, sum.axes_landmark += o.axes_landmark / n;
    sum.axes_between += o.axes_between / n, sum.nees_between += o.nees_between / n;
    sum.nees_pose += o.nees_pose / n, sum.nees_landmark += o.nees_landmark / n;
    sum.smoothed += o.smoothed / n, sum.reckoned += o.reckoned / n;
    sum.duplicates += o.duplicates, sum.false_ones += o.false_ones, sum.missed += o.missed;
    sum.wrong += o.wrong;
    sum.recognition.possible += o.recognition.possible;
    sum.recognition.right += o.recognition.right, sum.recognition.wrong += o.recognition.wrong;
    sum.dropouts.insert(sum.dropouts.end(), o.dropouts.begin(), o.dropouts.end());
    sum.update_s.insert(sum.update_s.end(), o.update_s.begin(), o.update_s.end());
  }
  return sum;
}

/// Half of the 95 % band of the mean of so many sessions' squared errors, three degrees of freedom
/// each: what is common to a session, as GPS and first heading, is one sample of it.
double BandOf(std::size_t sessions) {
  return 1.96 * std::sqrt(6.0 / static_cast<double>(sessions));
}

std::string TextOfAxes(const Eigen::Vector3d& v) {
  return fmt::format("{:.2f} {:.2f} {:.2f}", v.x(), v.y(), v.z());
}
void PrintSummary(const std::vector<Outcome>& all) {
  const Outcome sum = Together(all);
  std::vector<double> smoothed;
  for (const Outcome& o : all)
    smoothed.push_back(o.smoothed);
  fmt::print(
      "{} sessions: reckoned {:.3f}, smoothed mean {:.3f}, 90 % {:.3f}, worst {:.3f} m; duplicates "
      "{}, false {}, "
      "missed {}, wrong boxes {}\n  NEES of poses {:.2f}, of landmarks {:.2f} (3 +- {:.2f}); "
      "updates: median {:.4f}, 99 % {:.3f}, max {:.2f} ms\n",
      all.size(), sum.reckoned, sum.smoothed, Quantile(smoothed, 0.9), Quantile(smoothed, 1.0),
      sum.duplicates, sum.false_ones, sum.missed, sum.wrong, sum.nees_pose, sum.nees_landmark,
      BandOf(all.size()), 1e3 * Quantile(sum.update_s, 0.5), 1e3 * Quantile(sum.update_s, 0.99),
      1e3 * Quantile(sum.update_s, 1.0));
  fmt::print("  per axis (1 each): poses {}, landmarks {}; between landmarks {}, together {:.2f}\n",
             TextOfAxes(sum.axes_pose), TextOfAxes(sum.axes_landmark), TextOfAxes(sum.axes_between),
             sum.nees_between);
  constexpr std::size_t kPlaces = 3;  // of a session
  for (std::size_t k = 0; k < std::min(kPlaces, sum.dropouts.size()); ++k) {
    double off = 0.0, sigma = 0.0, nees = 0.0, worst = 0.0;
    for (std::size_t i = k; i < sum.dropouts.size(); i += kPlaces) {
      const PlaceError& error = sum.dropouts[i];
      off += error.off, sigma += error.sigma, nees += error.nees;
      worst = std::max(worst, error.nees);
    }
    const auto n = static_cast<double>(all.size());
    fmt::print("  {}: {:.2f} m off, {:.2f} m claimed, NEES {:.2f} (2), worst {:.1f}\n",
               k == 0   ? "amid the dropout"
               : k == 1 ? "at its end"
                        : "30 s later",
               off / n, sigma / n, nees / n, worst);
  }
  if (sum.recognition.possible > 0) {
    fmt::print("  of the former session's objects {} of {} known again, {} wrongly\n",
               sum.recognition.right, sum.recognition.possible, sum.recognition.wrong);
  }
}

std::vector<Outcome> RunScene(const Options& options) {
  std::vector<Outcome> outcomes;
  for (int seed = options.first; seed < options.first + options.count; ++seed) {
    StreamScene scene = Scenes().at(options.scene);
    scene.seed = static_cast<std::uint64_t>(seed);
    const EarlierSession earlier =
        options.has_former ? EarlierOf(scene, options.former_frame) : EarlierSession{};
    scene.standing = options.standing;
    scene.true_fix_error *= options.fix_error;
    SimulatedStream session = SimulateStream(scene);
    if (options.silent) session.stream = WithoutVelocity(session.stream, *options.silent);
    outcomes.push_back(PrintSession(session, earlier, seed, options));
  }
  return outcomes;
}

/// Sessions in worlds that are not as believed, a row each.
void PrintErrors() {
  fmt::print("{}", kErrorsHead);
  for (const ErrorScene& error : ErrorScenes(Scenes().at("hour"))) {
    const Options options{.scene = error.name, .first = 301, .count = 30, .is_markdown = true};
    const std::vector<Outcome> all = RunScene(options);
    const Outcome sum = Together(all);
    const double worst = std::ranges::max(all, {}, &Outcome::smoothed).smoothed;
    fmt::print("| {} ({}) | {:.3f} | {:.3f} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} |\n",
               error.meaning, error.name, sum.smoothed, worst, sum.duplicates, sum.false_ones,
               sum.missed, sum.nees_pose, sum.nees_landmark, sum.nees_between);
  }
}

void PrintHonesty() {
  fmt::print("{}", kHonestyHead);
  const double start = ThreadTime().value();
  for (const auto& [scene, count, text] :
       {std::tuple{"table1", 50, "10 minutes, 4 objects"},
        std::tuple{"hour", 50, "1 hour, 14 objects"},
        std::tuple{"dropouts", 50, "1 hour, 5 long dropouts"},
        std::tuple{"day", 50, "6 hours, 50 objects, up every hour"},
        std::tuple{"deep", 20, "6 hours, 20 objects, never up"}}) {
    const Options options{.scene = scene, .count = count, .is_markdown = true};
    const Outcome o = Together(RunScene(options));
    const double band = BandOf(static_cast<std::size_t>(count));
    fmt::print(
        "| {} ({}) | {} | {:.2f} | {:.2f} | {:.2f} .. {:.2f} | {} | {} | {:.2f} | {} | {:.3f} |\n",
        text, scene, count, o.nees_pose, o.nees_landmark, std::max(3.0 - band, 0.0), 3.0 + band,
        TextOfAxes(o.axes_pose), TextOfAxes(o.axes_landmark), o.nees_between,
        TextOfAxes(o.axes_between), o.smoothed);
  }
  fmt::print(fmt::runtime(kHonestyTail), ThreadTime().value() - start);
  PrintErrors();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  bool prints_errors = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--oracle") {
      options.has_oracle = true;
    } else if (word == "--former") {
      options.has_former = true;
    } else if (word == "--another") {
      options.former_frame.is_of_another_place = true;
    } else if (word == "--details") {
      options.has_details = true;
    } else if (word == "--markdown") {
      options.is_markdown = true;
    } else if (word == "--errors") {
      prints_errors = true;
    } else if (i + 1 < argc && word == "--scene") {
      options.scene = argv[++i];
    } else if (i + 1 < argc && word == "--seed") {
      options.first = std::stoi(argv[++i]);
    } else if (i + 1 < argc && word == "--changed") {
      options.former_frame.changed = std::stod(argv[++i]);
    } else if (i + 1 < argc && word == "--shift") {
      options.former_frame.shift_m = std::stod(argv[++i]);
    } else if (i + 1 < argc && word == "--turn") {
      options.former_frame.turn_deg = std::stod(argv[++i]);
    } else if (i + 1 < argc && word == "--silent") {
      options.silent = IntervalOf(argv[++i]);
    } else if (i + 1 < argc && word == "--fixes") {
      options.fix_error = std::stod(argv[++i]);
    } else if (i + 1 < argc && word == "--standing") {
      options.standing = IntervalOf(argv[++i]);
    } else if (i + 1 < argc && word == "--seeds") {
      options.count = std::stoi(argv[++i]);
    }
  }
  if (options.is_markdown || prints_errors) {
    prints_errors ? PrintErrors() : PrintHonesty();
    return 0;
  }
  if (!Scenes().contains(options.scene)) {
    fmt::print(stderr, "no scene `{}`\n", options.scene);
    return 2;
  }
  fmt::print(
      "seed  nodes | reckon online smooth    abs | lmk du fa mi   max  mean | right wrng miss |  "
      "NEES  lmk   btw | med ms    p99     max total s\n");
  PrintSummary(RunScene(options));
  return 0;
}
