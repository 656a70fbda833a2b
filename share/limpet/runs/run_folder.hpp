// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/runs/folder_lock.hpp"
#include "limpet/runs/written_files.hpp"

namespace limpet {

/// The folder of one run: locked while it is written, and nothing in it is written over or removed
/// but what an earlier run left.
class RunFolder {
 public:
  enum class Use { kNewRun, kReport };
  /// Creates the folder if it is missing and locks it. Throws Refusal if another process holds it,
  /// or if a new run is to go where something lies that is no run.
  RunFolder(std::filesystem::path folder, Use use);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] WrittenFiles& written() { return *written_; }

  /// Makes room for a run of `sessions`: removes what an earlier run left, but for the sessions
  /// `kept`. A session that a crash cut is set aside, and said so. Throws Refusal, before anything
  /// is touched, if something that Limpet did not write is in the way.
  void MakeRoomFor(const std::vector<std::string>& sessions, const std::vector<std::string>& kept);

  /// Writes files of a report, by name in the folder: each aside and renamed, so that a reader
  /// never meets half a file. Throws Refusal if Limpet did not write what is there.
  void Write(const std::map<std::string, std::string>& files);
  /// Removes figures of earlier reports that `files` does not have.
  void RemoveOtherFigures(const std::map<std::string, std::string>& files);

 private:
  std::filesystem::path path_;
  std::unique_ptr<FolderLock> lock_;
  std::optional<WrittenFiles> written_;
};

/// A folder that is being filled, while it lives; then what is in it counts as written.
class FilledFolder {
 public:
  FilledFolder(WrittenFiles& written, std::filesystem::path part)
      : written_(written), part_(std::move(part)) {
    written_.Begin(part_);
  }
  FilledFolder(const FilledFolder&) = delete;
  FilledFolder& operator=(const FilledFolder&) = delete;
  ~FilledFolder();

 private:
  WrittenFiles& written_;
  std::filesystem::path part_;
};

}  // namespace limpet
