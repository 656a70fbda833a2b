// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "limpet/durable/file_system.hpp"

namespace limpet {

/// A disk that fails on demand, as others do: full, it takes what fits (half a piece, here) and
/// says ENOSPC; failing, it takes nothing and says EIO, to a sync as well; read-only, EROFS.
/// Between that it is the disk behind it.
class FailingFileSystem final : public FileSystem {
 public:
  enum class Fault { kNone, kFull, kFailing, kReadOnly };
  /// Room as much as the disk has, in State::room.
  static constexpr std::uint64_t kRoomOfDisk = UINT64_MAX;
  /// What fails now; any thread or process may say.
  struct State {
    std::atomic<Fault> fault{Fault::kNone};
    std::atomic<std::uint64_t> room{kRoomOfDisk};  ///< [bytes]
  };

  /// Its own: fails as Set and SetRoom say. How much room the machine's disk has is no matter of
  /// such a run: nothing until it was full once, then 10 GiB.
  explicit FailingFileSystem(FileSystem& disk) : disk_(disk) {}
  /// Fails as `state` says, which outlives it. The room is the disk's own.
  FailingFileSystem(FileSystem& disk, const State& state) : disk_(disk), state_(state) {}

  void Set(Fault fault) {
    own_.fault = fault;
    if (fault == Fault::kFull) was_full_ = true;
  }
  /// From now on it has so much room left [bytes], or enough again.
  void SetRoom(std::optional<std::uint64_t> bytes) {
    if (bytes) was_full_ = true;
    own_.room = bytes.value_or(kRoomOfDisk);
  }
  [[nodiscard]] Fault fault() const { return state_.fault; }
  /// What one says who writes; nothing while it works.
  [[nodiscard]] std::error_code TroubleOfWriting() const;
  /// What one says who changes or syncs what is there, for which a full disk has room; nothing
  /// while it works.
  [[nodiscard]] std::error_code TroubleOfChanging() const;

  [[nodiscard]] Opened Open(const std::filesystem::path& path, Opening how) override;
  [[nodiscard]] std::error_code Rename(const std::filesystem::path& from,
                                       const std::filesystem::path& to) override;
  [[nodiscard]] std::error_code Link(const std::filesystem::path& existing,
                                     const std::filesystem::path& name) override;
  [[nodiscard]] std::error_code Remove(const std::filesystem::path& path) override;
  [[nodiscard]] std::error_code CreateFolder(const std::filesystem::path& path) override;
  [[nodiscard]] std::error_code SyncFolder(const std::filesystem::path& path) override;
  /// 0 while it is full, what it is limited to while it is.
  [[nodiscard]] std::optional<std::uint64_t> Room(const std::filesystem::path& path) const override;

 private:
  FileSystem& disk_;
  State own_;
  const State& state_ = own_;
  std::atomic<bool> was_full_{false};
};

}  // namespace limpet
