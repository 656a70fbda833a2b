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
  explicit FailingFileSystem(FileSystem& disk) : disk_(disk) {}

  void Set(Fault fault) {
    fault_ = fault;
    if (fault == Fault::kFull) {
      was_full_ = true;
    }
  }
  /// From now on it has so much room left [bytes], or enough again.
  void SetRoom(std::optional<std::uint64_t> bytes) {
    if (bytes) was_full_ = true;
    room_ = bytes.value_or(kRoomMade);
  }
  [[nodiscard]] Fault fault() const { return fault_; }
  /// What one says who writes; nothing while it works.
  [[nodiscard]] std::error_code TroubleOfWriting() const;
  /// Likewise who changes or syncs what is there: a full disk has room for that.
  [[nodiscard]] std::error_code TroubleOfChanging() const;

  [[nodiscard]] Opened Open(const std::filesystem::path& path, Opening how) override;
  [[nodiscard]] std::error_code Rename(const std::filesystem::path& from,
                                       const std::filesystem::path& to) override;
  [[nodiscard]] std::error_code Remove(const std::filesystem::path& path) override;
  [[nodiscard]] std::error_code CreateFolder(const std::filesystem::path& path) override;
  [[nodiscard]] std::error_code SyncFolder(const std::filesystem::path& path) override;
  /// 0 while it is full, what SetRoom says, 10 GiB once room has been made; nothing before, so that
  /// a run does not depend on the machine's disk.
  [[nodiscard]] std::optional<std::uint64_t> Room(const std::filesystem::path& path) const override;

 private:
  static constexpr std::uint64_t kRoomMade = std::uint64_t{10} << 30U;

  FileSystem& disk_;
  std::atomic<Fault> fault_{Fault::kNone};
  std::atomic<bool> was_full_{false};
  std::atomic<std::uint64_t> room_{kRoomMade};
};

}  // namespace limpet
