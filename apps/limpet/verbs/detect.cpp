// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/detect.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/core/params.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command DetectForm() {
  return {.name = "limpet detect",
          .words = "<images or folders>",
          .about =
              "Runs the detector alone and writes CSV: image,class,confidence,x,y,w,h in "
              "pixels, x and y of the box's upper left corner. An image that cannot be read "
              "is named and makes the exit code 1; the others are still done.",
          .options = {{.names = "--out",
                       .value = "FILE",
                       .meaning = "where the table goes",
                       .is_required = true},
                      {.names = "--min-confidence",
                       .value = "C",
                       .meaning = "only boxes of at least this confidence",
                       .fallback = "0",
                       .rule = NumberBetween(0.0, 1.0)},
                      {.names = "--detector",
                       .value = "NAME",
                       .meaning = "`limpet describe` lists them and their keys",
                       .fallback = "color_shape"},
                      {.names = "--set",
                       .value = "KEY=V",
                       .meaning = "override a parameter of the detector",
                       .is_repeatable = true}},
          .takes = "images and --out FILE",
          .least_words = 1};
}

bool IsImageName(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  constexpr std::array kKnown{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".ppm", ".webp"};
  return std::ranges::find(kKnown, extension) != kKnown.end();
}

/// Files as given; of a folder its images in the order of their names.
std::vector<fs::path> ImagesOf(const std::vector<std::string>& given) {
  std::vector<fs::path> images;
  for (const std::string& name : given) {
    if (!fs::is_directory(name)) {
      images.emplace_back(name);
      continue;
    }
    std::vector<fs::path> inside;
    for (const fs::directory_entry& entry : fs::directory_iterator(name)) {
      if (entry.is_regular_file() && IsImageName(entry.path())) {
        inside.push_back(entry.path());
      }
    }
    std::ranges::sort(inside);
    images.insert(images.end(), inside.begin(), inside.end());
  }
  return images;
}

/// Quoted if the name holds what would end a CSV field.
std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return quoted + "\"";
}

/// The detector that --detector names, with the parameters that --set gives.
std::unique_ptr<Detector> DetectorOf(const Arguments& arguments) {
  auto factory = FindDetector(*arguments.Find("detector"));
  if (!factory) {
    throw UsageError("--detector: " + factory.error().text);
  }
  ConfigBlock block{.name = "--set", .where = {.file = "--set", .line = 0}, .entries = {}};
  for (const std::string& setting : arguments.All("set")) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    block.entries.push_back({.key = setting.substr(0, equals),
                             .value = setting.substr(std::min(equals + 1, setting.size())),
                             .where = block.where});
  }
  const std::vector<ConfigProblem> problems = ApplyBlock(block, (*factory)->Parameters());
  if (!problems.empty()) {
    throw UsageError(problems.front().Format());
  }
  return (*factory)->Make();
}

/// Returns how many images could not be read.
int DetectAll(Detector& detector, const std::vector<fs::path>& images, double least_confidence,
              std::ostream& out) {
  int failed = 0;
  out << "image,class,confidence,x,y,w,h\n";
  for (const fs::path& file : images) {
    const Expected<Image> image = ReadImage(file);
    if (!image) {
      fmt::print(stderr, "limpet detect: {}\n", image.error().text);
      ++failed;
      continue;
    }
    for (const Box& box : detector.Detect(image->view())) {
      if (box.confidence >= least_confidence) {
        out << fmt::format("{},{},{:.3f},{:.1f},{:.1f},{:.1f},{:.1f}\n", CsvField(file.string()),
                           box.color, box.confidence, box.u - 0.5 * box.w, box.v - 0.5 * box.h,
                           box.w, box.h);
      }
    }
  }
  return failed;
}

int DetectInImages(const Arguments& arguments) {
  const std::string out_name = *arguments.Find("out");
  const double least_confidence = *arguments.Number("min-confidence");
  const std::unique_ptr<Detector> detector = DetectorOf(arguments);
  const std::vector<fs::path> images = ImagesOf(arguments.positionals());
  if (images.empty()) {
    fmt::print(stderr, "limpet detect: no image found\n");
    return kFailed;
  }
  std::ofstream out(out_name);
  if (!out) {
    fmt::print(stderr, "limpet detect: {}: cannot be written\n", out_name);
    return kFailed;
  }
  const int failed = DetectAll(*detector, images, least_confidence, out);
  out.close();
  if (!out) {
    fmt::print(stderr, "limpet detect: {}: writing failed\n", out_name);
    return kFailed;
  }
  return failed == 0 ? kOk : kFailed;
}

}  // namespace

int RunDetect(std::span<const std::string> args) {
  return RunCommand(DetectForm(), args, DetectInImages);
}

}  // namespace limpet
