// SPDX-License-Identifier: MIT
// How far pictures of the simulated camera are from real ones:
//   image_formation statistics FOLDER...   of the pictures of folders, mean over each folder
//   image_formation plain                  of the plain look
//   image_formation real [FOLDER]          of the real look on every seabed; pictures to FOLDER
//   image_formation sheet FILE             one picture of each look and seabed on one sheet
//   image_formation cost                   CPU time of a picture
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/imaging/picture_renderer.hpp"
#include "limpet/vision/image_file.hpp"
#include "limpet/vision/scene_renderer.hpp"
#include "tests/bench/image_formation/picture_statistics.hpp"

namespace limpet {
namespace {

constexpr double kDepth = 7.5;

double Depth(const Eigen::Vector2d& p_W) {
  return kDepth + 0.07 * std::sin(1.3 * p_W.x()) * std::cos(0.8 * p_W.y());
}

Pose PoseOf(int frame, double altitude) {
  Pose pose;
  pose.p_WB = {1.7 * frame, 0.9 * frame, kDepth - altitude};
  pose.yaw = 0.4 * frame;
  pose.roll = 0.02 * std::sin(frame);
  return pose;
}

void PrintHead() {
  fmt::print(
      "| pictures | n | luminance 1-99 % | spread | in 16 px | in 8 px | gradient 50, 95 % | edges "
      "| chroma | its spread |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
}

void PrintMean(std::string_view name, const std::vector<PictureStatistics>& all) {
  const auto mean = [&all](double PictureStatistics::*member) {
    double sum = 0.0;
    for (const PictureStatistics& one : all)
      sum += one.*member;
    return sum / static_cast<double>(all.size());
  };
  using S = PictureStatistics;
  fmt::print(
      "| {} | {} | {:.0f}-{:.0f} | {:.1f} | {:.1f} | {:.1f} | {:.1f}, {:.1f} | {:.3f} | {:.1f} | "
      "{:.1f} |\n",
      name, all.size(), mean(&S::dark), mean(&S::bright), mean(&S::spread), mean(&S::local_spread),
      mean(&S::fine_spread), mean(&S::gradient_50), mean(&S::gradient_95), mean(&S::edges),
      mean(&S::chroma), mean(&S::chroma_spread));
}

void OfFolder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".png" || extension == ".jpg") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<PictureStatistics> all;
  for (const auto& file : files) {
    if (const auto picture = ReadImage(file)) all.push_back(StatisticsOf(picture->view()));
  }
  PrintMean(folder.filename().string(), all);
}

void OfPlainLook() {
  SceneRenderer renderer({.camera = {}, .seabed_depth = Depth, .visibility_m = 8.0});
  std::vector<PictureStatistics> all;
  for (int i = 0; i < 12; ++i) {
    const Pose pose = PoseOf(i, 4.0);
    const Sphere ball{{pose.p_WB.x() + 0.5, pose.p_WB.y() - 0.7, 7.0}, 0.5, "yellow"};
    all.push_back(
        StatisticsOf(renderer.Render(pose, std::span(&ball, 1), static_cast<unsigned>(i)).view()));
  }
  PrintMean("plain look", all);
}

PictureSettings RealLook(const std::string& seabed) {
  PictureSettings settings{.scene = {.camera = {}, .seabed_depth = Depth}, .image = {}};
  settings.image.look = "real";
  settings.image.seabed.kind = seabed;
  return settings;
}

/// Objects of every kind around the place below the body.
std::vector<Solid> SolidsNear(const Pose& pose, int frame) {
  std::vector<Solid> solids(2);
  const auto at = [&pose](double north, double east, double above) {
    return Eigen::Vector3d(pose.p_WB.x() + north, pose.p_WB.y() + east, kDepth - above);
  };
  solids[0] = {.p_W = at(0.8, -1.2, 0.5 + 0.3 * (frame % 3)), .radius = 0.3, .color = "yellow"};
  const std::vector<std::string> kinds = SolidKindNames();
  const auto kind = static_cast<std::size_t>(frame) % kinds.size();
  solids[1] = {.kind = *SolidKindOf(kinds[kind]),
               .p_W = at(-0.6, 0.9, 0.25),
               .radius = 0.25,
               .height = 0.5,
               .color = frame % 2 == 0 ? "orange" : "white",
               .band_color = frame % 4 < 2 ? "" : "red"};
  return solids;
}

cv::Mat MatOf(Image& image) { return {image.height_px, image.width_px, CV_8UC3, image.bgr.data()}; }

void OfRealLook(const std::string& seabed, const std::filesystem::path& folder) {
  PictureRenderer renderer(RealLook(seabed));
  std::vector<PictureStatistics> all;
  for (int i = 0; i < 12; ++i) {
    const Pose pose = PoseOf(i, 2.0 + 0.5 * (i % 5));
    Image image =
        renderer.Render(pose, SolidsNear(pose, i), static_cast<unsigned>(i), Seconds(0.25 * i));
    all.push_back(StatisticsOf(image.view()));
    if (!folder.empty()) {
      cv::imwrite((folder / fmt::format("{}_{:02}.png", seabed, i)).string(), MatOf(image));
    }
  }
  PrintMean(seabed, all);
}

/// Pictures of half the size, three abreast: plain, then every seabed, at other waters and lights.
void WriteSheet(const std::string& file) {
  std::vector<cv::Mat> pictures;
  const auto add = [&pictures](Image image) {
    cv::Mat half;
    cv::resize(MatOf(image), half, {320, 240}, 0.0, 0.0, cv::INTER_AREA);
    pictures.push_back(half);
  };
  const Pose first = PoseOf(2, 3.0);
  SceneRenderer plain({.camera = {}, .seabed_depth = Depth, .visibility_m = 8.0});
  const Sphere ball{SolidsNear(first, 2)[0].p_W, 0.3, "yellow"};
  add(plain.Render(first, std::span(&ball, 1), 0));
  const auto shoot = [&](PictureSettings settings, int frame, double altitude) {
    const Pose pose = PoseOf(frame, altitude);
    add(PictureRenderer(settings).Render(pose, SolidsNear(pose, frame), 0, Seconds(0.3 * frame)));
  };
  shoot(RealLook("sand"), 2, 3.0);
  shoot(RealLook("gravel"), 3, 2.5);
  shoot(RealLook("rock"), 1, 3.0);
  shoot(RealLook("seagrass"), 4, 3.0);
  shoot(RealLook("mixed"), 8, 4.0);
  PictureSettings clear = RealLook("mixed");
  clear.scene.visibility_m = 20.0;
  clear.image.water.dissolved = 0.05;
  shoot(clear, 5, 3.0);
  PictureSettings murky = RealLook("mixed");
  murky.scene.visibility_m = 3.5;
  murky.image.water.dissolved = 1.8;
  shoot(murky, 6, 2.0);
  PictureSettings night = RealLook("rock");
  night.image.light.sun = 0.0;
  night.image.light.lamp = 1.0;
  shoot(night, 7, 2.0);
  std::vector<cv::Mat> rows(pictures.size() / 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    cv::hconcat(&pictures[3 * i], 3, rows[i]);
  }
  cv::Mat sheet;
  cv::vconcat(rows, sheet);
  cv::imwrite(file, sheet, {cv::IMWRITE_JPEG_QUALITY, 80});
}

double CpuMs() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// The least of several rounds: what else the machine does only adds.
template <class Work>
double LeastMs(const Work& work) {
  double best = 1e9;
  for (int round = 0; round < 12; ++round) {
    const double start = CpuMs();
    constexpr int kTimes = 5;
    for (int i = 0; i < kTimes; ++i)
      work(kTimes * round + i);
    best = std::min(best, (CpuMs() - start) / kTimes);
  }
  return best;
}

void PrintCost() {
  cv::setNumThreads(1);
  const cv::Mat noise(480, 640, CV_8UC3, cv::Scalar(90, 120, 60));
  cv::Mat blurred;
  const double blur = LeastMs([&](int) { cv::GaussianBlur(noise, blurred, {5, 5}, 1.0); });
  const auto print = [blur](const char* name, double ms) {
    fmt::print("{:<28} {:6.2f} ms {:6.1f} x\n", name, ms, ms / blur);
  };
  print("cv::GaussianBlur 5 x 5", blur);
  SceneRenderer plain({.camera = {}, .seabed_depth = Depth, .visibility_m = 8.0});
  print("plain look", LeastMs([&](int i) {
          static_cast<void>(plain.Render(PoseOf(i, 3.5), {}, static_cast<unsigned>(i)));
        }));
  for (const bool has_objects : {false, true}) {
    PictureRenderer renderer(RealLook("mixed"));
    print(has_objects ? "real look, two objects" : "real look", LeastMs([&](int i) {
            const Pose pose = PoseOf(i, 3.5);
            const std::vector<Solid> solids = SolidsNear(pose, i);
            static_cast<void>(renderer.Render(pose, std::span(solids).first(has_objects ? 2 : 0),
                                              static_cast<unsigned>(i), Seconds(0.25 * i)));
          }));
  }
}

int Run(int argc, char** argv) {
  const std::string_view verb = argc > 1 ? argv[1] : "";
  if (verb == "statistics") {
    PrintHead();
    for (int i = 2; i < argc; ++i)
      OfFolder(argv[i]);
  } else if (verb == "plain") {
    PrintHead();
    OfPlainLook();
  } else if (verb == "real") {
    PrintHead();
    for (const char* seabed : {"sand", "gravel", "rock", "seagrass", "mixed"}) {
      OfRealLook(seabed, argc > 2 ? argv[2] : "");
    }
  } else if (verb == "sheet" && argc > 2) {
    WriteSheet(argv[2]);
  } else if (verb == "cost") {
    PrintCost();
  } else {
    fmt::print(stderr,
               "usage: image_formation statistics FOLDER... | plain | real [FOLDER] | sheet FILE | "
               "cost\n");
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) { return limpet::Run(argc, argv); }
