// SPDX-License-Identifier: MIT
// Fits how far a network's boxes are to be believed, on pictures of ordinary seas as those that
// `limpet detect --characterise` renders (what it learned from is harder than any sea):
//   calibrate_network NETWORK.yaml WORLDS SEED
// A box is right if its overlap (IoU) with a ball is at least 0.5, whatever colour it names. Writes
// its lines `confidence_...` of NETWORK.yaml anew: a logistic curve in the logits of score and
// colour and in the roundness of the outline.
#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "limpet/characterisation/detector_trial.hpp"
#include "limpet/detectors/image_mat.hpp"
#include "limpet/detectors/network_detector.hpp"
#include "limpet/objects/pixel_rect.hpp"

#include "training/detector/labelled_picture.hpp"

namespace limpet {
namespace {

using Features = Eigen::Vector4d;  // 1, logit of score, logit of colour, roundness

struct Example {
  Features features;
  bool is_right = false;
};

std::vector<BallLabel> BallsOf(const TrialPicture& picture) {
  constexpr double kLeastVisible = 0.5;
  const Image& image = picture.image;
  LabelledPicture labelled;
  for (const TrialLook& look : picture.looks) {
    if (look.kind != SolidKind::kSphere) continue;
    BallLabel label;
    label.box = {.u = look.visible.center_u(),
                 .v = look.visible.center_v(),
                 .w = look.visible.width(),
                 .h = look.visible.height(),
                 .confidence = 1.0,
                 .color = look.color};
    label.is_unclear = look.visible_fraction < kLeastVisible;
    labelled.labels.push_back(std::move(label));
  }
  labelled.pixels = MatOf(image.view());
  MarkUnclear(labelled);
  return labelled.labels;
}

/// What the proposals teach; those at an unclear ball teach nothing.
void AddExamples(const std::vector<BallLabel>& labels,
                 const std::vector<NetworkProposal>& proposals, std::vector<Example>& examples) {
  for (const NetworkProposal& proposal : proposals) {
    const BallLabel* nearest = nullptr;
    double most = 0.0;
    for (const BallLabel& label : labels) {
      const double overlap = Overlap(RectOf(label.box), RectOf(proposal.box));
      if (overlap > most) most = overlap, nearest = &label;
    }
    if (nearest != nullptr && nearest->is_unclear && most > 0.2) continue;
    const bool is_right = most >= 0.5;
    examples.push_back(
        {{1.0, proposal.score_logit, proposal.color_logit, proposal.roundness}, is_right});
  }
}

double ChanceOf(const Features& theta, const Features& features) {
  return 1.0 / (1.0 + std::exp(-theta.dot(features)));
}

/// Maximum of the likelihood by Newton's method.
Features Fit(const std::vector<Example>& examples) {
  Features theta = Features::Zero();
  for (int round = 0; round < 50; ++round) {
    Features gradient = -1e-3 * theta;
    Eigen::Matrix4d curvature = 1e-3 * Eigen::Matrix4d::Identity();
    for (const Example& one : examples) {
      const double p = ChanceOf(theta, one.features);
      gradient += ((one.is_right ? 1.0 : 0.0) - p) * one.features;
      curvature += p * (1.0 - p) * one.features * one.features.transpose();
    }
    theta += curvature.ldlt().solve(gradient);
  }
  return theta;
}

/// Replaces the value of `key: value` lines.
std::string WithValue(const std::string& text, const std::string& key, double value) {
  std::string changed;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    changed += (line.starts_with(key + ":") ? fmt::format("{}: {:.3f}", key, value) : line) + '\n';
  return changed;
}

void WriteInto(const std::string& file, const Features& theta) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  std::string changed = WithValue(text.str(), "confidence_offset", theta[0]);
  // Nothing is less likely to be a ball for looking more like one.
  changed = WithValue(changed, "confidence_per_score", std::max(0.0, theta[1]));
  changed = WithValue(changed, "confidence_per_color", std::max(0.0, theta[2]));
  changed = WithValue(changed, "confidence_per_roundness", std::max(0.0, theta[3]));
  std::ofstream out(file);
  out << changed;
  if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
}

int Run(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: calibrate_network NETWORK.yaml WORLDS SEED\n");
    return 2;
  }
  NetworkDetector detector({.network = argv[1]});
  std::vector<Example> examples;
  TrialPlan plan;
  plan.worlds = std::stoi(argv[2]);
  plan.seed = std::stoull(argv[3]);
  MakeTrialPictures(plan,
                    [&](const TrialPicture& picture) {
                      AddExamples(BallsOf(picture), detector.Propose(picture.image.view()),
                                  examples);
                    },
                    {});
  const Features theta = Fit(examples);
  double right = 0.0;
  double brier = 0.0;
  for (const Example& one : examples) {
    right += one.is_right ? 1.0 : 0.0;
    brier += std::pow(ChanceOf(theta, one.features) - (one.is_right ? 1.0 : 0.0), 2.0);
  }
  const auto count = static_cast<double>(examples.size());
  fmt::print("{} boxes, {:.3f} of them right; Brier score {:.4f}\n", examples.size(), right / count,
             brier / count);
  WriteInto(argv[1], theta);
  return 0;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  try {
    return limpet::Run(argc, argv);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "calibrate_network: {}\n", problem.what());
    return 1;
  }
}
