// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/durable/file_system.hpp"

namespace limpet {

/// A disk whose power can be cut. It does what it is asked in the file system below, where all can
/// be read back, and keeps an account of it; from that it makes, for a cut at any call, a state
/// that the disk may then be in: what was not synced is dropped, torn at any byte, or done while
/// what came before it is not; names that were made, moved or removed since their folder was synced
/// are as before or as after. Nothing else is lost. Not thread-safe but for its calls of
/// FileSystem.
class TornDisk final : public FileSystem {
 public:
  /// Begins with `root` as it is, which counts as synced.
  explicit TornDisk(std::filesystem::path root);
  ~TornDisk() override;

  [[nodiscard]] Opened Open(const std::filesystem::path& path, Opening how) override;
  [[nodiscard]] std::error_code Rename(const std::filesystem::path& from,
                                       const std::filesystem::path& to) override;
  [[nodiscard]] std::error_code Link(const std::filesystem::path& existing,
                                     const std::filesystem::path& name) override;
  [[nodiscard]] std::error_code Remove(const std::filesystem::path& path) override;
  [[nodiscard]] std::error_code CreateFolder(const std::filesystem::path& path) override;
  [[nodiscard]] std::error_code SyncFolder(const std::filesystem::path& path) override;
  [[nodiscard]] std::optional<std::uint64_t> Room(const std::filesystem::path& path) const override;

  /// Calls so far, syncs among them.
  [[nodiscard]] std::size_t calls() const;
  /// Leaves in `folder`, in place of `root`, what a cut after the first `calls` calls may leave.
  void Cut(std::size_t calls, Random& random, const std::filesystem::path& folder) const;

 private:
  friend class TornFile;
  class Account;
  std::unique_ptr<Account> account_;
  std::filesystem::path root_;
};

}  // namespace limpet
