// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/detect.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/vision/color_shape_detector.hpp"
#include "limpet/vision/image_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDetectHelp =
    "usage: limpet detect <images or folders> --out FILE [--min-confidence C]\n"
    "  writes CSV image,class,confidence,x,y,w,h; pixels, x y of the upper left corner\n";

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

double LeastConfidence(const Arguments& arguments) {
  const std::optional<std::string> text = arguments.Find("min-confidence");
  if (!text) {
    return 0.0;
  }
  const std::optional<double> value = ParseNumber(*text);
  if (!value || *value < 0.0 || *value > 1.0) {
    throw UsageError(fmt::format("--min-confidence {}: allowed: 0 to 1", *text));
  }
  return *value;
}

/// Returns how many images could not be read.
int DetectAll(const std::vector<fs::path>& images, double least_confidence, std::ostream& out) {
  ColorShapeDetector detector;
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

int RunChecked(const Arguments& arguments) {
  const std::optional<std::string> out_name = arguments.Find("out");
  if (arguments.positionals().empty() || !out_name) {
    throw UsageError("needs images and --out FILE");
  }
  const double least_confidence = LeastConfidence(arguments);
  const std::vector<fs::path> images = ImagesOf(arguments.positionals());
  if (images.empty()) {
    fmt::print(stderr, "limpet detect: no image found\n");
    return kFailed;
  }
  std::ofstream out(*out_name);
  if (!out) {
    fmt::print(stderr, "limpet detect: {}: cannot be written\n", *out_name);
    return kFailed;
  }
  const int failed = DetectAll(images, least_confidence, out);
  out.close();
  if (!out) {
    fmt::print(stderr, "limpet detect: {}: writing failed\n", *out_name);
    return kFailed;
  }
  return failed == 0 ? kOk : kFailed;
}

}  // namespace

int RunDetect(std::span<const std::string> args) {
  try {
    const Arguments arguments(args, {"out", "min-confidence"}, {"help"});
    if (arguments.Has("help")) {
      fmt::print("{}", kDetectHelp);
      return kOk;
    }
    return RunChecked(arguments);
  } catch (const UsageError& error) {
    fmt::print(stderr, "limpet detect: {}\n{}", error.what(), kDetectHelp);
    return ExitCode::kUsage;
  }
}

}  // namespace limpet
