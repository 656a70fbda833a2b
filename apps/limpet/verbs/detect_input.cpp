// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/detect_input.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <sys/stat.h>

#include "limpet/console/arguments.hpp"
#include "limpet/core/config.hpp"
#include "limpet/vision/video_frames.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

bool IsImageName(const fs::path& file) {
  constexpr std::array<std::string_view, 15> kKnown{".png", ".jpg", ".jpeg", ".jpe",  ".jp2",
                                                    ".bmp", ".dib", ".tif",  ".tiff", ".ppm",
                                                    ".pgm", ".pbm", ".pnm",  ".pxm",  ".webp"};
  return std::ranges::any_of(kKnown,
                             [extension = file.extension().string()](std::string_view known) {
                               return EqualsIgnoringCase(extension, known);
                             });
}

void SayPassedOver(const std::string& folder, const std::vector<fs::path>& files) {
  if (files.empty()) return;
  const fs::path& first = files.front();
  fmt::print(stderr, "limpet detect: {}: {} passed over, no image that it reads: {}{}{}\n", folder,
             files.size() == 1 ? "one file" : fmt::format("{} files", files.size()),
             first.filename().string(), files.size() == 1 ? "" : " and others", AdviceOn(first));
}

void SayFoldersPassedOver(const std::string& folder, const std::vector<fs::path>& folders) {
  if (folders.empty()) return;
  fmt::print(stderr, "limpet detect: {}: {} in it passed over, give each by its name: {}{}\n",
             folder, folders.size() == 1 ? "one folder" : fmt::format("{} folders", folders.size()),
             folders.front().filename().string(), folders.size() == 1 ? "" : " and others");
}

std::vector<DetectInput> InputsIn(const std::string& folder) {
  std::vector<fs::path> inside, others, folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) folders.push_back(entry.path());
    if (!entry.is_regular_file()) continue;
    const fs::path& file = entry.path();
    const bool is_taken = IsImageName(file) || (IsVideoName(file) && CanReadVideos());
    (is_taken ? inside : others).push_back(file);
  }
  std::ranges::sort(inside);
  std::ranges::sort(others);
  std::ranges::sort(folders);
  SayPassedOver(folder, others);
  SayFoldersPassedOver(folder, folders);
  std::vector<DetectInput> inputs;
  for (const fs::path& file : inside)
    inputs.push_back({.file = file, .is_video = IsVideoName(file)});
  return inputs;
}

}  // namespace

std::vector<DetectInput> DetectInputsOf(const std::vector<std::string>& given) {
  std::vector<DetectInput> inputs;
  for (const std::string& name : given) {
    if (fs::is_directory(name)) {
      const std::vector<DetectInput> inside = InputsIn(name);
      inputs.insert(inputs.end(), inside.begin(), inside.end());
    } else {
      inputs.push_back({.file = name, .is_video = IsVideoName(name) && CanReadVideos()});
    }
  }
  return inputs;
}

std::string AdviceOn(const fs::path& file) {
  if (!IsVideoName(file) || CanReadVideos()) return "";
  return fmt::format(
      "; a video is read where there is the program ffmpeg; else give its frames: ffmpeg -i {} "
      "frame_%06d.png",
      file.string());
}

DrawingNames::DrawingNames(const std::vector<DetectInput>& inputs, const fs::path& table,
                           std::optional<fs::path> folder)
    : folder_(std::move(folder)), images_(inputs.size()) {
  for (const DetectInput& input : inputs) {
    if (const auto id = IdOf(input.file)) read_.insert(*id);
  }
  if (IsRead(table)) {
    throw UsageError(fmt::format("--out: {} is an image that is read", table.string()));
  }
  if (!folder_) return;
  std::error_code ignored;
  if (fs::weakly_canonical(table, ignored).parent_path() ==
      fs::weakly_canonical(*folder_ / "x", ignored).parent_path()) {
    taken_.insert(*folder_ / table.filename());
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].is_video) continue;
    images_[i] = NewName(inputs[i].file.stem().string());
    if (!IsRead(images_[i])) continue;
    throw UsageError(fmt::format("--draw: {} is an image that is read, and would be written over",
                                 images_[i].string()));
  }
}

fs::path DrawingNames::OfFrame(const fs::path& video, int number) {
  fs::path name;
  do {
    name = NewName(fmt::format("{}_{:06}", video.stem().string(), number));
  } while (IsRead(name));
  return name;
}

std::optional<DrawingNames::FileId> DrawingNames::IdOf(const fs::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return std::nullopt;
  return FileId{found.st_dev, found.st_ino};
}

bool DrawingNames::IsRead(const fs::path& file) const {
  const std::optional<FileId> id = IdOf(file);
  return id && read_.contains(*id);
}

fs::path DrawingNames::NewName(const std::string& stem) {
  fs::path name = *folder_ / (stem + ".png");
  for (int i = 2; !taken_.insert(name).second; ++i)
    name = *folder_ / fmt::format("{}-{}.png", stem, i);
  return name;
}

}  // namespace limpet
