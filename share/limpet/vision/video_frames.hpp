// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

#include "limpet/core/expected.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// True if the file's name has the extension of a video.
[[nodiscard]] bool IsVideoName(const std::filesystem::path& file);
/// True if the program `ffmpeg` is on PATH.
[[nodiscard]] bool CanReadVideos();

/// A video's pictures one at a time, as the program `ffmpeg` decodes them; there are never more
/// than one in memory.
class VideoFrames {
 public:
  explicit VideoFrames(std::filesystem::path video);
  VideoFrames(const VideoFrames&) = delete;
  VideoFrames& operator=(const VideoFrames&) = delete;
  /// Ends ffmpeg if the video is not over.
  ~VideoFrames();

  /// Nothing behind the last one; or if `problem()` says what is wrong, which names the video.
  [[nodiscard]] std::optional<Image> Next();
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  /// How many pictures Next has given.
  [[nodiscard]] int count() const { return count_; }

 private:
  void Start();
  /// Waits for ffmpeg: how it ended if that was no success.
  [[nodiscard]] std::string End();
  void Fail(const std::string& what);

  std::filesystem::path video_;
  std::FILE* pipe_ = nullptr;
  pid_t child_ = -1;
  int count_ = 0;
  std::optional<Error> problem_;
};

}  // namespace limpet
