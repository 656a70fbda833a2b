// SPDX-License-Identifier: MIT
// What `limpet detect` reads, and what it may therefore not write over.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace limpet {

struct DetectInput {
  std::filesystem::path file;
  bool is_video = false;  ///< and there is a program that reads it
};

/// Files as given; of a folder its images and videos in the order of their names. Says on stderr
/// what of a folder is passed over.
[[nodiscard]] std::vector<DetectInput> DetectInputsOf(const std::vector<std::string>& given);

/// What to do about a file that is a video, behind a complaint; empty for others.
[[nodiscard]] std::string AdviceOn(const std::filesystem::path& file);

/// Where drawings go: one never hides another, nor the table, nor a file that is read.
class DrawingNames {
 public:
  /// Throws UsageError if the table, or the drawing of an image, would be written over a file that
  /// is read. Nothing is written. `folder`: where drawings go; nothing: there are none.
  DrawingNames(const std::vector<DetectInput>& inputs, const std::filesystem::path& table,
               std::optional<std::filesystem::path> folder);

  /// File that the drawing of the input with this index goes to; empty for a video, and where no
  /// drawings are wanted.
  [[nodiscard]] const std::filesystem::path& OfImage(std::size_t index) const {
    return images_[index];
  }
  /// File that the drawing of a video's picture `number` goes to. REQUIRES: drawings are wanted.
  [[nodiscard]] std::filesystem::path OfFrame(const std::filesystem::path& video, int number);
  [[nodiscard]] bool are_wanted() const { return folder_.has_value(); }

 private:
  using FileId = std::pair<dev_t, ino_t>;

  [[nodiscard]] static std::optional<FileId> IdOf(const std::filesystem::path& file);
  [[nodiscard]] bool IsRead(const std::filesystem::path& file) const;
  [[nodiscard]] std::filesystem::path NewName(const std::string& stem);

  std::optional<std::filesystem::path> folder_;
  std::set<FileId> read_;
  std::set<std::filesystem::path> taken_;
  std::vector<std::filesystem::path> images_;  ///< by input
};

}  // namespace limpet
