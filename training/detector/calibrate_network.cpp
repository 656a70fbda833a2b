// SPDX-License-Identifier: MIT
// Fits how far a network's boxes are to be believed:
//   calibrate_network NETWORK.yaml WORLDS STUDIO SEED
// on WORLDS seas as those that `limpet detect --characterise` renders, 20 pictures each, and on
// STUDIO composed pictures: either alone has its own share of what looks like a ball and is none,
// which a logistic curve learns with the rest. A box is right if its overlap (IoU) with a ball is
// at least 0.5, whatever colour it names and however faint the ball. Writes the lines
// `confidence_...` and `witnesses_...` of NETWORK.yaml anew: logistic curves in the logits of score
// and colour and in the roundness of the outline; the second also in what color_shape says.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "limpet/characterisation/detector_trial.hpp"
#include "limpet/core/logistic.hpp"
#include "limpet/detectors/combined_detector.hpp"
#include "limpet/objects/pixel_rect.hpp"

#include "training/detector/labelled_picture.hpp"
#include "training/detector/picture_series.hpp"

namespace limpet {
namespace {

using Features = Eigen::VectorXd;  // 1 first

struct Example {
  Features features;
  bool is_right = false;
};

std::vector<BallLabel> BallsOf(const TrialPicture& picture) {
  constexpr double kLeastVisible = 0.5;
  std::vector<BallLabel> balls;
  for (const TrialLook& look : picture.looks) {
    if (look.kind != SolidKind::kSphere) continue;
    BallLabel ball;
    ball.box = {.u = look.visible.center_u(),
                .v = look.visible.center_v(),
                .w = look.visible.width(),
                .h = look.visible.height(),
                .confidence = 1.0,
                .color = look.color};
    ball.is_hidden = look.visible_fraction < kLeastVisible;
    balls.push_back(std::move(ball));
  }
  return balls;
}

enum class Verdict { kRight, kWrong, kUnclear };

/// Whether a box lies on a ball; one at a ball that is hardly in sight teaches nothing.
Verdict Judge(const std::vector<BallLabel>& labels, const Box& box) {
  const BallLabel* nearest = nullptr;
  double most = 0.0;
  for (const BallLabel& label : labels) {
    const double overlap = Overlap(RectOf(label.box), RectOf(box));
    if (overlap > most) most = overlap, nearest = &label;
  }
  if (nearest != nullptr && nearest->is_hidden && most > 0.2) return Verdict::kUnclear;
  return most >= 0.5 ? Verdict::kRight : Verdict::kWrong;
}

/// What is known of a detector's boxes: features, and whether they were right.
class Examples {
 public:
  void Add(Verdict verdict, std::initializer_list<double> features) {
    if (verdict == Verdict::kUnclear) return;
    all_.push_back({Eigen::Map<const Features>(std::data(features),
                                               static_cast<Eigen::Index>(features.size())),
                    verdict == Verdict::kRight});
  }
  /// Weights of the features: maximum of the likelihood by Newton's method.
  [[nodiscard]] Features Fit() const {
    if (all_.empty()) throw std::runtime_error("the detector found nothing to be fitted");
    const Eigen::Index size = all_.front().features.size();
    Features theta = Features::Zero(size);
    for (int round = 0; round < 50; ++round) {
      Features gradient = -1e-3 * theta;
      Eigen::MatrixXd curvature = 1e-3 * Eigen::MatrixXd::Identity(size, size);
      for (const Example& one : all_) {
        const double p = ChanceOf(theta, one.features);
        gradient += ((one.is_right ? 1.0 : 0.0) - p) * one.features;
        curvature += p * (1.0 - p) * one.features * one.features.transpose();
      }
      theta += curvature.ldlt().solve(gradient);
    }
    return theta;
  }
  void Print(const char* name, const Features& theta) const {
    double right = 0.0;
    double brier = 0.0;
    for (const Example& one : all_) {
      right += one.is_right ? 1.0 : 0.0;
      brier += std::pow(ChanceOf(theta, one.features) - (one.is_right ? 1.0 : 0.0), 2.0);
    }
    const auto count = static_cast<double>(all_.size());
    fmt::print("{}: {} boxes, {:.3f} of them right; Brier score {:.4f}\n", name, all_.size(),
               right / count, brier / count);
  }

 private:
  [[nodiscard]] static double ChanceOf(const Features& theta, const Features& features) {
    return Logistic(theta.dot(features));
  }
  std::vector<Example> all_;
};

/// Replaces the value of `key: value` lines.
std::string WithValue(const std::string& text, const std::string& key, double value) {
  std::string changed;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    changed += (line.starts_with(key + ":") ? fmt::format("{}: {:.3f}", key, value) : line) + '\n';
  return changed;
}

/// Examples of a network alone, and of one that color_shape stands beside.
class Lessons {
 public:
  explicit Lessons(const std::string& network) : detector_({.network = network}) {}

  void Learn(const ImageView& picture, const std::vector<BallLabel>& balls) {
    for (const WitnessedProposal& proposal : detector_.Propose(picture)) {
      const NetworkProposal& network = proposal.network;
      const Verdict verdict = Judge(balls, network.box);
      const WitnessFeatures f = FeaturesOf(proposal);
      together_.Add(verdict, {1.0, f.score, f.color, f.roundness, f.shape_found, f.shape});
      if (proposal.is_of_network) {
        alone_.Add(verdict, {1.0, network.score_logit, network.color_logit, network.roundness});
      }
    }
  }
  void WriteInto(const std::string& file) const {
    const Features alone = alone_.Fit();
    const Features together = together_.Fit();
    alone_.Print("network", alone);
    together_.Print("combined", together);
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    // Nothing is less likely to be a ball for looking more like one.
    const auto weight = [](double fitted) { return std::max(0.0, fitted); };
    std::string changed = WithValue(text.str(), "confidence_offset", alone[0]);
    changed = WithValue(changed, "confidence_per_score", weight(alone[1]));
    changed = WithValue(changed, "confidence_per_color", weight(alone[2]));
    changed = WithValue(changed, "confidence_per_roundness", weight(alone[3]));
    changed = WithValue(changed, "witnesses_offset", together[0]);
    changed = WithValue(changed, "witnesses_per_score", weight(together[1]));
    changed = WithValue(changed, "witnesses_per_color", weight(together[2]));
    changed = WithValue(changed, "witnesses_per_roundness", weight(together[3]));
    changed = WithValue(changed, "witnesses_shape_found", together[4]);
    changed = WithValue(changed, "witnesses_per_shape", weight(together[5]));
    std::ofstream out(file);
    out << changed;
    if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
  }

 private:
  CombinedDetector detector_;
  Examples alone_, together_;
};

int Calibrate(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: calibrate_network NETWORK.yaml WORLDS STUDIO SEED\n");
    return 2;
  }
  const int worlds = std::stoi(argv[2]);
  const int studio = std::stoi(argv[3]);
  const std::uint64_t seed = std::stoull(argv[4]);
  Lessons lessons(argv[1]);
  TrialPlan plan;
  plan.worlds = worlds;
  plan.seed = seed;
  MakeTrialPictures(
      plan,
      [&](const TrialPicture& picture) { lessons.Learn(picture.image.view(), BallsOf(picture)); },
      {});
  MakePictures({.studio = studio, .rendered = 0, .seed = seed}, [&](const LabelledPicture& one) {
    lessons.Learn({one.pixels.ptr(), one.pixels.cols, one.pixels.rows}, one.labels);
  });
  lessons.WriteInto(argv[1]);
  return 0;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  try {
    return limpet::Calibrate(argc, argv);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "calibrate_network: {}\n", problem.what());
    return 1;
  }
}
