// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/detect.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/detect_input.hpp"
#include "limpet/characterisation/detector_sheet.hpp"
#include "limpet/characterisation/detector_trial.hpp"
#include "limpet/console/arguments.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/core/params.hpp"
#include "limpet/logbook/alog_csv.hpp"
#include "limpet/objects/color_table.hpp"
#include "limpet/vision/box_drawing.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_file.hpp"
#include "limpet/vision/video_frames.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command DetectForm() {
  return {.name = "limpet detect",
          .words = "<images, videos or folders> | --characterise",
          .about =
              "Runs the detector alone and writes CSV: image,class,confidence,x,y,w,h in "
              "pixels, x and y of the box's upper left corner. An image that cannot be read "
              "is named and makes the exit code 1; the others are still done. Videos are read "
              "through the program ffmpeg, if it is on PATH; their pictures are called "
              "FILE#000001 and so on. With --characterise "
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
                       .rule = WholeNumber(2, 10000)},
                      {.names = "--colors",
                       .value = "LIST",
                       .meaning = "of the things in these worlds: the colours sought",
                       .fallback = "yellow,orange,green"},
                      {.names = "--seed",
                       .value = "S",
                       .meaning = "of these worlds",
                       .fallback = "1",
                       .rule = WholeNumber(0, 1'000'000'000)},
                      {.names = "--force", .meaning = "writes over a detector's file"},
                      {.names = "--set",
                       .value = "KEY=V",
                       .meaning = "override a parameter of the detector",
                       .is_repeatable = true}},
          .takes = "images and --out FILE"};
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

/// What is done with every picture.
struct Detection {
  Detector& detector;
  double least_confidence;
  std::ostream& table;
  DrawingNames& drawings;
};

/// The complaint if its boxes could not be drawn.
std::optional<Error> DetectIn(Image& image, const std::string& name, const fs::path& drawing,
                              Detection& how) {
  std::vector<Box> boxes = how.detector.Detect(image.view());
  std::erase_if(boxes, [&](const Box& box) { return box.confidence < how.least_confidence; });
  for (const Box& box : boxes) {
    how.table << fmt::format("{},{},{:.3f},{:.1f},{:.1f},{:.1f},{:.1f}\n", CsvField(name),
                             box.color, box.confidence, box.u - 0.5 * box.w, box.v - 0.5 * box.h,
                             box.w, box.h);
  }
  if (!how.drawings.are_wanted()) return std::nullopt;
  DrawBoxes(boxes, image);
  return WriteImage(drawing, image);
}

/// Its pictures are named FILE#000001 and so on, as ffmpeg counts them.
std::optional<Error> DetectInVideo(const fs::path& file, Detection& how) {
  VideoFrames frames(file);
  while (std::optional<Image> image = frames.Next()) {
    const std::string name = fmt::format("{}#{:06}", file.string(), frames.count());
    const fs::path drawing =
        how.drawings.are_wanted() ? how.drawings.OfFrame(file, frames.count()) : fs::path();
    if (auto problem = DetectIn(*image, name, drawing, how)) return problem;
  }
  return frames.problem();
}

std::optional<Error> DetectInFile(const fs::path& file, const fs::path& drawing, Detection& how) {
  Expected<Image> image = ReadImage(file);
  if (!image) return Error{image.error().text + AdviceOn(file)};
  return DetectIn(*image, file.string(), drawing, how);
}

/// Returns how many images and videos could not be read to their end, or drawn.
int DetectAll(const std::vector<DetectInput>& inputs, Detection& how) {
  int failed = 0;
  how.table << "image,class,confidence,x,y,w,h\n";
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const fs::path& file = inputs[i].file;
    const std::optional<Error> problem = inputs[i].is_video
                                             ? DetectInVideo(file, how)
                                             : DetectInFile(file, how.drawings.OfImage(i), how);
    if (!problem) continue;
    fmt::print(stderr, "limpet detect: {}\n", problem->text);
    ++failed;
  }
  return failed;
}

/// Throws Refusal if drawings cannot be written there.
void MakeDrawingFolder(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (!fs::is_directory(folder, problem)) {
    throw Refusal(fmt::format("{}: cannot be a folder", folder.string()));
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    throw Refusal(fmt::format("{}: cannot be written to", folder.string()));
  }
}

/// Throws UsageError for an option that would do nothing.
void RefuseIdleOptions(const Arguments& arguments) {
  const bool is_trial = arguments.Has("characterise");
  const std::vector<std::string> idle =
      is_trial ? std::vector<std::string>{"min-confidence", "draw"}
               : std::vector<std::string>{"worlds", "colors", "seed", "force"};
  for (const std::string& option : idle) {
    if (!arguments.Has(option)) continue;
    throw UsageError(is_trial ? fmt::format("--characterise takes no --{}", option)
                              : fmt::format("--{} does nothing without --characterise", option));
  }
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

/// Throws UsageError.
void CheckTrial(const Arguments& arguments) {
  if (!arguments.positionals().empty())
    throw UsageError("--characterise renders its own pictures and takes none");
  const std::string out = *arguments.Find("out");
  if (fs::path(out).extension() != ".yaml")
    throw UsageError(fmt::format("--out: {}: a detector's file is a .yaml", out));
}

int Characterise(const Arguments& arguments) {
  CheckTrial(arguments);
  const std::unique_ptr<Detector> detector = DetectorOf(arguments);
  // Refused before the work, not after.
  CommandOutput output(arguments.Find("out"), arguments.Has("force"), {});
  TrialPlan plan;
  plan.colors = ColorsOf(arguments);
  plan.worlds = arguments.Integer("worlds");
  plan.seed = static_cast<std::uint64_t>(arguments.Integer("seed"));
  const TrialResult trial = RunTrial(plan, *detector, [&plan](int done) {
    if (done % 10 == 0) fmt::print(stderr, "{} of {} worlds\n", done, plan.worlds);
  });
  const bool finds = std::ranges::any_of(trial.looks, [](const TrialLook& look) {
    return look.kind == SolidKind::kSphere && look.found.has_value();
  });
  if (!finds) throw Refusal("the detector found no ball in any picture: there is no model of that");
  if (const auto problem = TooFewBalls(trial)) throw Refusal(*problem);
  output.Write(DetectorSheetText({.detector = *arguments.Find("detector"),
                                  .made_with = CommandOf(arguments),
                                  .file = output.path().filename().string()},
                                 trial));
  output.Commit();
  return kOk;
}

int DetectInImages(const Arguments& arguments) {
  const std::string out_name = *arguments.Find("out");
  const std::unique_ptr<Detector> detector = DetectorOf(arguments);
  const std::vector<DetectInput> inputs = DetectInputsOf(arguments.positionals());
  if (inputs.empty()) {
    fmt::print(stderr, "limpet detect: no image found\n");
    return kFailed;
  }
  const std::optional<std::string> folder = arguments.Find("draw");
  DrawingNames drawings(inputs, out_name, folder);
  if (folder) MakeDrawingFolder(*folder);
  std::ofstream out(out_name);
  if (!out) {
    fmt::print(stderr, "limpet detect: {}: cannot be written\n", out_name);
    return kFailed;
  }
  Detection how{.detector = *detector,
                .least_confidence = *arguments.Number("min-confidence"),
                .table = out,
                .drawings = drawings};
  const int failed = DetectAll(inputs, how);
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
    RefuseIdleOptions(arguments);
    if (arguments.Has("characterise")) return Characterise(arguments);
    if (arguments.positionals().empty()) throw UsageError("detect takes images and --out FILE");
    return DetectInImages(arguments);
  });
}

}  // namespace limpet
