// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/detect.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/characterisation/detector_sheet.hpp"
#include "limpet/characterisation/detector_trial.hpp"
#include "limpet/console/arguments.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/core/params.hpp"
#include "limpet/logbook/alog_csv.hpp"
#include "limpet/vision/box_drawing.hpp"
#include "limpet/vision/color_table.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command DetectForm() {
  return {.name = "limpet detect",
          .words = "<images or folders> | --characterise",
          .about =
              "Runs the detector alone and writes CSV: image,class,confidence,x,y,w,h in "
              "pixels, x and y of the box's upper left corner. An image that cannot be read "
              "is named and makes the exit code 1; the others are still done. With --characterise "
              "it renders pictures of its own, measures what the detector finds by range, size, "
              "water and kind, and writes the file that DetectorFile in a mission names.",
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
                      {.names = "--draw",
                       .value = "DIR",
                       .meaning = "also write each image there, its boxes drawn"},
                      {.names = "--characterise",
                       .meaning = "measure the detector; takes no images, --out is a .yaml"},
                      {.names = "--worlds",
                       .value = "N",
                       .meaning = "of 20 pictures each, that it is measured in",
                       .fallback = "60",
                       .rule = NumberBetween(2.0, 10000.0)},
                      {.names = "--colors",
                       .value = "LIST",
                       .meaning = "of the things in these worlds: the colours sought",
                       .fallback = "yellow,orange,green"},
                      {.names = "--seed",
                       .value = "S",
                       .meaning = "of these worlds",
                       .fallback = "1",
                       .rule = NumberBetween(0.0, 1e9)},
                      {.names = "--set",
                       .value = "KEY=V",
                       .meaning = "override a parameter of the detector",
                       .is_repeatable = true}},
          .takes = "images and --out FILE"};
}

std::string ExtensionOf(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return extension;
}

bool IsImageName(const fs::path& file) {
  const std::string extension = ExtensionOf(file);
  constexpr std::array kKnown{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".ppm", ".webp"};
  return std::ranges::find(kKnown, extension) != kKnown.end();
}

/// What to do about a file that is a video.
std::string AdviceOn(const fs::path& file) {
  constexpr std::array kVideos{".mp4", ".avi", ".mkv", ".mov", ".m4v", ".mpg", ".mpeg", ".webm"};
  if (std::ranges::find(kVideos, ExtensionOf(file)) == kVideos.end()) return "";
  return fmt::format("; of a video give its frames: ffmpeg -i {} frame_%06d.png", file.string());
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

/// Where an image goes that its boxes are drawn in: like names from several folders do not meet.
fs::path DrawnName(const fs::path& folder, const fs::path& image, std::set<fs::path>& taken) {
  const std::string stem = image.stem().string();
  fs::path name = folder / (stem + ".png");
  for (int i = 2; !taken.insert(name).second; ++i) {
    name = folder / fmt::format("{}-{}.png", stem, i);
  }
  return name;
}

/// What to do with an image's boxes.
struct BoxOutput {
  std::ostream& table;
  std::optional<fs::path> drawings;
  std::set<fs::path> drawn;
};

std::optional<Error> DetectIn(const fs::path& file, Detector& detector, double least_confidence,
                              BoxOutput& out) {
  Expected<Image> image = ReadImage(file);
  if (!image) return image.error();
  std::vector<Box> boxes = detector.Detect(image->view());
  std::erase_if(boxes, [&](const Box& box) { return box.confidence < least_confidence; });
  for (const Box& box : boxes) {
    out.table << fmt::format("{},{},{:.3f},{:.1f},{:.1f},{:.1f},{:.1f}\n", CsvField(file.string()),
                             box.color, box.confidence, box.u - 0.5 * box.w, box.v - 0.5 * box.h,
                             box.w, box.h);
  }
  if (!out.drawings) return std::nullopt;
  DrawBoxes(boxes, *image);
  return WriteImage(DrawnName(*out.drawings, file, out.drawn), *image);
}

/// Returns how many images could not be read, or drawn.
int DetectAll(Detector& detector, const std::vector<fs::path>& images, double least_confidence,
              BoxOutput& out) {
  int failed = 0;
  out.table << "image,class,confidence,x,y,w,h\n";
  for (const fs::path& file : images) {
    if (const auto problem = DetectIn(file, detector, least_confidence, out)) {
      fmt::print(stderr, "limpet detect: {}{}\n", problem->text, AdviceOn(file));
      ++failed;
    }
  }
  return failed;
}

/// Throws Refusal if it cannot be made.
std::optional<fs::path> DrawingFolder(const Arguments& arguments) {
  const std::optional<std::string> name = arguments.Find("draw");
  if (!name) return std::nullopt;
  std::error_code problem;
  fs::create_directories(*name, problem);
  if (!fs::is_directory(*name)) throw Refusal(fmt::format("{}: cannot be a folder", *name));
  return fs::path(*name);
}

/// Throws UsageError if one of them is none.
std::vector<std::string> ColorsOf(const Arguments& arguments) {
  std::vector<std::string> colors;
  const std::vector<std::string> known = ColorNames();
  for (const std::string& word : Split(*arguments.Find("colors"), ',')) {
    const std::string color(Trim(word));
    if (std::ranges::find(known, color) == known.end()) {
      const std::string nearest = NearestWord(color, known);
      throw UsageError(fmt::format("--colors: `{}` is no colour{}", color,
                                   nearest.empty() ? "" : "; did you mean `" + nearest + "`?"));
    }
    colors.push_back(color);
  }
  return colors;
}

/// The command that makes the file again.
std::string CommandOf(const Arguments& arguments) {
  std::string text =
      fmt::format("limpet detect --characterise --detector {} --colors {} --worlds {} --seed {}",
                  *arguments.Find("detector"), *arguments.Find("colors"), *arguments.Find("worlds"),
                  *arguments.Find("seed"));
  for (const std::string& setting : arguments.All("set"))
    text += " --set " + setting;
  return text;
}

int Characterise(const Arguments& arguments) {
  if (!arguments.positionals().empty())
    throw UsageError("--characterise renders its own pictures and takes none");
  const std::unique_ptr<Detector> detector = DetectorOf(arguments);
  CommandOutput output(arguments.Find("out"), true, {});  // refused before the work, not after
  TrialPlan plan;
  plan.colors = ColorsOf(arguments);
  plan.worlds = static_cast<int>(*arguments.Number("worlds"));
  plan.seed = static_cast<std::uint64_t>(*arguments.Number("seed"));
  const TrialResult trial = RunTrial(plan, *detector, [&plan](int done) {
    if (done % 10 == 0) fmt::print(stderr, "{} of {} worlds\n", done, plan.worlds);
  });
  const bool finds = std::ranges::any_of(trial.looks, [](const TrialLook& look) {
    return look.kind == SolidKind::kSphere && look.found.has_value();
  });
  if (!finds) throw Refusal("the detector found no ball in any picture: there is no model of that");
  output.Write(DetectorSheetText(
      {.detector = *arguments.Find("detector"), .made_with = CommandOf(arguments)}, trial));
  output.Commit();
  return kOk;
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
  BoxOutput output{.table = out, .drawings = DrawingFolder(arguments), .drawn = {}};
  const int failed = DetectAll(*detector, images, least_confidence, output);
  out.close();
  if (!out) {
    fmt::print(stderr, "limpet detect: {}: writing failed\n", out_name);
    return kFailed;
  }
  return failed == 0 ? kOk : kFailed;
}

}  // namespace

int RunDetect(std::span<const std::string> args) {
  return RunCommand(DetectForm(), args, [](const Arguments& arguments) {
    if (arguments.Has("characterise")) return Characterise(arguments);
    if (arguments.positionals().empty()) throw UsageError("detect takes images and --out FILE");
    return DetectInImages(arguments);
  });
}

}  // namespace limpet
