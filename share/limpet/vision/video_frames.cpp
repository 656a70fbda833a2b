// SPDX-License-Identifier: MIT
// OpenCV's videoio is no dependency: it draws in whole desktops. Who has videos has ffmpeg.
#include "limpet/vision/video_frames.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/config.hpp"
#include "limpet/core/program_search.hpp"

namespace limpet {
namespace {

constexpr const char* kProgram = "ffmpeg";
constexpr int kMostPixels = 100'000'000;

/// Blanks, a whole number and the one character behind it; nothing if there is none.
std::optional<int> NumberFrom(std::FILE* in) {
  constexpr int kMost = 1'000'000;
  int letter = std::fgetc(in);
  while (letter == ' ' || letter == '\n')
    letter = std::fgetc(in);
  if (letter < '0' || letter > '9') return std::nullopt;
  int value = 0;
  for (; letter >= '0' && letter <= '9' && value < kMost; letter = std::fgetc(in))
    value = 10 * value + (letter - '0');
  return letter == ' ' || letter == '\n' ? std::optional(value) : std::nullopt;
}

/// `P6 <width> <height> 255`, then red, green and blue; an empty image for anything else.
Image PpmFrom(std::FILE* in) {
  const int first = std::fgetc(in), second = std::fgetc(in);
  if (first != 'P' || second != '6') return {};
  const std::optional<int> width = NumberFrom(in), height = NumberFrom(in), most = NumberFrom(in);
  if (!width || !height || most != 255) return {};
  if (*width < 1 || *height < 1 || *width > kMostPixels / *height) return {};
  Image image{*width, *height, {}};
  image.bgr.resize(3 * static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height));
  if (std::fread(image.bgr.data(), 1, image.bgr.size(), in) != image.bgr.size()) return {};
  for (std::size_t i = 0; i < image.bgr.size(); i += 3)
    std::swap(image.bgr[i], image.bgr[i + 2]);
  return image;
}

/// What posix_spawn does in the child: nothing to read, its pictures into the pipe; what it
/// complains of goes where our own complaints go.
class ChildStreams {
 public:
  explicit ChildStreams(int output) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
  }
  ChildStreams(const ChildStreams&) = delete;
  ChildStreams& operator=(const ChildStreams&) = delete;
  ~ChildStreams() { ::posix_spawn_file_actions_destroy(&actions_); }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// No shell sees these words. `file:` so that no name is taken for an address on a network; rgb24
/// because of 10-bit videos, whose pictures would come with two bytes a color.
std::vector<std::string> WordsFor(const std::filesystem::path& video) {
  return {kProgram, "-v",         "error", "-nostdin", "-i",       "file:" + video.string(),
          "-f",     "image2pipe", "-c:v",  "ppm",      "-pix_fmt", "rgb24",
          "-"};
}

}  // namespace

bool IsVideoName(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 8> kVideos{".mp4", ".avi", ".mkv",  ".mov",
                                                    ".m4v", ".mpg", ".mpeg", ".webm"};
  return std::ranges::any_of(kVideos,
                             [extension = file.extension().string()](std::string_view known) {
                               return EqualsIgnoringCase(extension, known);
                             });
}

bool CanReadVideos() { return FindOnPath(kProgram).has_value(); }

VideoFrames::VideoFrames(std::filesystem::path video) : video_(std::move(video)) { Start(); }

VideoFrames::~VideoFrames() {
  if (child_ > 0) ::kill(child_, SIGKILL);
  static_cast<void>(End());
}

void VideoFrames::Start() {
  const std::optional<std::filesystem::path> program = FindOnPath(kProgram);
  std::array<int, 2> ends{};
  if (!std::filesystem::is_regular_file(video_)) return Fail("no such file");
  if (!program) return Fail("a video, and there is no ffmpeg that reads it");
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return Fail(std::generic_category().message(errno));
  std::vector<std::string> words = WordsFor(video_);
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  const int failure = ::posix_spawn(&child_, program->c_str(), ChildStreams(ends[1]).get(), nullptr,
                                    argv.data(), environ);
  ::close(ends[1]);
  pipe_ = ::fdopen(ends[0], "r");
  if (failure != 0) {
    child_ = -1;
    Fail(fmt::format("{}: {}", program->string(), std::generic_category().message(failure)));
  }
}

std::optional<Image> VideoFrames::Next() {
  if (problem_ || pipe_ == nullptr) return std::nullopt;
  const int first = std::fgetc(pipe_);
  if (first == EOF) {
    const std::string ending = End();
    if (!ending.empty()) {
      Fail(fmt::format("{} after {} pictures", ending, count_));
    } else if (count_ == 0) {
      Fail("no picture in it");
    }
    return std::nullopt;
  }
  std::ungetc(first, pipe_);
  Image image = PpmFrom(pipe_);
  if (image.bgr.empty()) {
    const bool is_cut = std::feof(pipe_) != 0;
    if (!is_cut) ::kill(child_, SIGKILL);
    const std::string ending = End();
    Fail(is_cut ? fmt::format("{} in the midst of picture {}",
                              ending.empty() ? "ffmpeg ended" : ending, count_ + 1)
                : "what ffmpeg makes of it is no picture");
    return std::nullopt;
  }
  ++count_;
  return image;
}

std::string VideoFrames::End() {
  if (pipe_ != nullptr) std::fclose(pipe_);
  pipe_ = nullptr;
  if (child_ <= 0) return "";
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  if (WIFSIGNALED(status)) return fmt::format("ffmpeg was killed (signal {})", WTERMSIG(status));
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : fmt::format("ffmpeg failed (exit code {})", code);
}

void VideoFrames::Fail(const std::string& what) {
  problem_ = Error{fmt::format("{}: {}", video_.string(), what)};
}

}  // namespace limpet
