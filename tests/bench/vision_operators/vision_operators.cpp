// SPDX-License-Identifier: MIT
// Image operators written by hand and OpenCV's, on the same rendered 640 x 480 frames in one
// process: the least CPU time of 15 rounds, and what the results differ by.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/core/clock.hpp"
#include "limpet/core/random.hpp"
#include "limpet/detectors/blob_finder.hpp"
#include "limpet/detectors/color_planes.hpp"
#include "limpet/vision/ellipse.hpp"
#include "limpet/vision/scene_renderer.hpp"
#include "tests/bench/vision_operators/own_operators.hpp"

namespace limpet {
namespace {

constexpr double kLeastArea = 8.0;
constexpr double kNoise = 0.8;

double CpuMs() { return 1e3 * ThreadTime().value(); }

struct Way {
  const char* name;
  std::function<void(std::size_t)> run;  ///< on one of the inputs
};

/// Ways take turns, so that what else the machine does slows all of them.
void Compare(const char* operation, std::size_t inputs, const std::vector<Way>& ways) {
  constexpr int kRounds = 15;
  std::vector<double> best(ways.size(), 1e9);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const double start = CpuMs();
      for (std::size_t input = 0; input < inputs; ++input) {
        ways[i].run(input);
      }
      best[i] = std::min(best[i], (CpuMs() - start) / static_cast<double>(inputs));
    }
  }
  fmt::print("{}\n", operation);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    fmt::print("  {:<44} {:8.4f} ms {:6.2f} x\n", ways[i].name, best[i], best[i] / best[0]);
  }
}

cv::Mat MatOf(Image& image) { return {image.height_px, image.width_px, CV_8UC3, image.bgr.data()}; }

std::vector<Image> Frames() {
  SceneRenderer renderer({.camera = {},
                          .seabed_depth = [](const Eigen::Vector2d&) { return 7.5; },
                          .visibility_m = 6.0,
                          .seabed_seed = 2,
                          .noise_seed = 3});
  std::vector<Image> frames;
  for (std::uint32_t i = 0; i < 12; ++i) {
    Pose pose;
    pose.p_WB = {1.7 * i, 0.4 * i, 3.5};
    const std::vector<Sphere> balls{{{1.7 * i + 0.5, 0.4 * i - 0.9, 6.5}, 0.4, "yellow"},
                                    {{1.7 * i - 0.8, 0.4 * i + 1.1, 7.0}, 0.5, "orange"}};
    frames.push_back(renderer.Render(pose, balls, i));
  }
  return frames;
}

/// Reduction, planes and regions in the order of the detector.
class Planes {
 public:
  Planes() : frames_(Frames()), reduced_(frames_.size()) {
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      own::Reduce(frames_[i], reduced_[i]);
    }
  }
  void CompareReduction() {
    Image own_out;
    cv::Mat out;
    Compare("mean of 4 x 4 pixels", frames_.size(),
            {{"ours", [&](std::size_t i) { own::Reduce(frames_[i], own_out); }},
             {"cv::resize INTER_AREA", [&](std::size_t i) {
                cv::resize(MatOf(frames_[i]), out, {160, 120}, 0.0, 0.0, cv::INTER_AREA);
              }}});
    const cv::Mat ours = MatOf(own_out);
    fmt::print("  greatest difference: {} levels\n", cv::norm(ours, out, cv::NORM_INF));
  }
  void ComparePlanes() {
    std::array<own::Plane, 4> own_planes;
    ColorPlanes planes;
    Compare("four colour planes, 160 x 120", frames_.size(),
            {{"ours", [&](std::size_t i) { own::FillPlanes(reduced_[i], kNoise, own_planes); }},
             {"cv::transform, divide, sqrt",
              [&](std::size_t i) { planes.Fill(MatOf(reduced_[i]), kNoise); }}});
    double most = 0.0;
    for (std::size_t k = 0; k < own_planes.size(); ++k) {
      const cv::Mat ours(120, 160, CV_16S, own_planes[k].values.data());
      most = std::max(most, cv::norm(ours, planes.planes()[k], cv::NORM_INF));
    }
    fmt::print("  greatest difference: {} (one colour is 2048; ours truncates)\n", most);
  }
  void CompareRegions() {
    std::vector<own::Plane> planes;
    std::vector<std::vector<int>> levels;
    FillLevelSets(planes, levels);
    std::vector<own::Region> regions;
    std::vector<Blob> blobs;
    BlobFinder finder;
    std::size_t components = 0;
    const auto all = [&](std::size_t i, const std::function<void(const cv::Mat&, int)>& find) {
      const cv::Mat plane(120, 160, CV_16S, planes[i].values.data());
      for (const int level : levels[i]) {
        find(plane, level);
      }
    };
    cv::Mat mask, labels, stats, centers, one;
    const auto count_components = [&](const cv::Mat& plane, int level) {
      cv::compare(plane, level, mask, cv::CMP_GE);
      const int count = cv::connectedComponentsWithStats(mask, labels, stats, centers);
      for (int label = 1; label < count; ++label) {
        const int* at = stats.ptr<int>(label);
        if (at[cv::CC_STAT_AREA] >= kLeastArea) {
          cv::compare(labels(cv::Rect(at[0], at[1], at[2], at[3])), label, one, cv::CMP_EQ);
          components += cv::moments(one, true).m00 > 0.0 ? 1 : 0;
        }
      }
    };
    Compare("regions with second moments, all level sets of a plane", planes.size(),
            {{"ours (runs of pixels)",
              [&](std::size_t i) {
                regions.clear();
                for (const int level : levels[i]) {
                  own::FindRegions(planes[i], level, kLeastArea, regions);
                }
              }},
             {"cv::findContours, moments",
              [&](std::size_t i) {
                blobs.clear();
                all(i, [&](const cv::Mat& plane, int level) {
                  finder.Find(plane, level, kLeastArea, blobs);
                });
              }},
             {"cv::connectedComponentsWithStats, moments", [&](std::size_t i) {
                components = 0;
                all(i, count_components);
              }}});
    fmt::print("  regions in the last plane: {}, {}, {}\n", regions.size(), blobs.size(),
               components);
  }
  void CompareQuantiles() {
    std::vector<own::Plane> planes;
    std::vector<std::vector<int>> levels;
    FillLevelSets(planes, levels);
    ColorPlanes colors;
    Compare(
        "two quantiles and the maximum of a plane", planes.size(),
        {{"ours (nth_element of every third pixel)",
          [&](std::size_t i) { static_cast<void>(own::QuantilesAndMost(planes[i])); }},
         {"cv::calcHist, minMaxLoc", [&](std::size_t i) {
            static_cast<void>(colors.LevelsOf(cv::Mat(120, 160, CV_16S, planes[i].values.data())));
          }}});
  }
  void CompareRays() {
    Ellipse ellipse;
    ellipse.center = {320.0, 240.0};
    ellipse.axes << 60.0, 0.0, 5.0, 50.0;
    std::vector<double> profiles;
    cv::Mat x(own::kRays, own::kSteps, CV_32F), y(own::kRays, own::kSteps, CV_32F), out, projected;
    Compare("colours along 48 rays, projected", frames_.size(),
            {{"ours (nearest pixel)",
              [&](std::size_t i) {
                own::SampleRays(frames_[i].view(), ellipse, {0.1, 0.2, 0.3}, profiles);
              }},
             {"cv::remap INTER_NEAREST, transform", [&](std::size_t i) {
                for (int ray = 0; ray < own::kRays; ++ray) {
                  const double angle = 2.0 * std::numbers::pi * ray / own::kRays;
                  const Eigen::Vector2d along =
                      ellipse.axes * Eigen::Vector2d(std::cos(angle), std::sin(angle));
                  for (int step = 0; step < own::kSteps; ++step) {
                    const double scale = 0.55 + (step + 0.5) / own::kSteps;
                    const Eigen::Vector2d p = ellipse.center + scale * along;
                    x.at<float>(ray, step) = static_cast<float>(p.x() - 0.5);
                    y.at<float>(ray, step) = static_cast<float>(p.y() - 0.5);
                  }
                }
                cv::remap(MatOf(frames_[i]), out, x, y, cv::INTER_NEAREST);
                cv::transform(out, projected, cv::Matx14f(0.1F, 0.2F, 0.3F, 0.0F));
              }}});
  }

 private:
  void FillLevelSets(std::vector<own::Plane>& planes, std::vector<std::vector<int>>& levels) {
    ColorPlanes colors;
    for (Image& image : reduced_) {
      colors.Fill(MatOf(image), kNoise);
      for (const cv::Mat& plane : colors.planes()) {
        planes.push_back({160, 120, {plane.begin<std::int16_t>(), plane.end<std::int16_t>()}});
        levels.push_back(colors.LevelsOf(plane));
      }
    }
  }

  std::vector<Image> frames_;
  std::vector<Image> reduced_;
};

/// Points on an ellipse of 60 x 45 px over an arc, 0.5 px off, and a guess 4 px off.
struct Arc {
  std::vector<Eigen::Vector2d> points;
  std::vector<cv::Point2f> cv_points;

  Arc(double turn, Random& random) {
    for (int i = 0; i < 48; ++i) {
      const double angle = turn * i / 48.0;
      const double off_v = random.Normal(0.5), off_u = random.Normal(0.5);
      points.emplace_back(200.0 + 60.0 * std::cos(angle) + off_u,
                          150.0 + 45.0 * std::sin(angle) + off_v);
      cv_points.emplace_back(static_cast<float>(points.back().x()),
                             static_cast<float>(points.back().y()));
    }
  }
};

void CompareFits(const char* name, double share) {
  Random random(5);
  std::vector<Arc> arcs;
  for (int i = 0; i < 300; ++i) {
    arcs.emplace_back(2.0 * std::numbers::pi * share, random);
  }
  Ellipse guess;
  guess.center = {203.0, 147.0};
  guess.axes << 57.0, 0.0, 0.0, 48.0;
  const Eigen::Vector2d truth(200.0, 150.0);
  std::array<double, 4> squares{};
  const auto note = [&squares, &truth](std::size_t way, double u, double v) {
    squares[way] += (Eigen::Vector2d(u, v) - truth).squaredNorm();
  };
  const auto note_box = [&note](std::size_t way, const cv::RotatedRect& box) {
    note(way, box.center.x, box.center.y);
  };
  const std::vector<Way> ways{
      {"ours (least squares, pulled to the guess)",
       [&](std::size_t i) {
         const Ellipse fit = FitEllipse(arcs[i].points, guess).value_or(guess);
         note(0, fit.center.x(), fit.center.y());
       }},
      {"cv::fitEllipse", [&](std::size_t i) { note_box(1, cv::fitEllipse(arcs[i].cv_points)); }},
      {"cv::fitEllipseAMS",
       [&](std::size_t i) { note_box(2, cv::fitEllipseAMS(arcs[i].cv_points)); }},
      {"cv::fitEllipseDirect",
       [&](std::size_t i) { note_box(3, cv::fitEllipseDirect(arcs[i].cv_points)); }}};
  Compare(name, arcs.size(), ways);
  fmt::print("  rms error of the centre:");
  for (const double sum : squares) {
    fmt::print(" {:.2f}", std::sqrt(sum / (15.0 * static_cast<double>(arcs.size()))));
  }
  fmt::print(" px\n");
}

}  // namespace
}  // namespace limpet

int main() {
  cv::setNumThreads(0);
  limpet::Planes planes;
  planes.CompareReduction();
  planes.ComparePlanes();
  planes.CompareQuantiles();
  planes.CompareRegions();
  planes.CompareRays();
  limpet::CompareFits("ellipse through 48 points all round, 0.5 px off", 1.0);
  limpet::CompareFits("ellipse through 48 points of a third of it, 0.5 px off", 1.0 / 3.0);
  return 0;
}
