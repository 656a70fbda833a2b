// SPDX-License-Identifier: MIT
// Pictures with labels that train.py learns from, or is held out against:
//   training_frames FOLDER STUDIO RENDERED SEED
// STUDIO composed pictures, then RENDERED ones of the simulated camera. Equal seeds, equal bytes.
#include <exception>
#include <string>

#include <fmt/format.h>

#include "training/detector/frame_file.hpp"
#include "training/detector/picture_series.hpp"

namespace {

int MakeFrames(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: training_frames FOLDER STUDIO RENDERED SEED\n");
    return 2;
  }
  limpet::FrameFile file(argv[1]);
  limpet::MakePictures(
      {.studio = std::stoi(argv[2]), .rendered = std::stoi(argv[3]), .seed = std::stoull(argv[4])},
      [&file](const limpet::LabelledPicture& picture) { file.Add(picture); });
  fmt::print("{} pictures in {}\n", file.frames(), argv[1]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return MakeFrames(argc, argv);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "training_frames: {}\n", problem.what());
    return 1;
  }
}
