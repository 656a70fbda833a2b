// SPDX-License-Identifier: MIT
#include "limpet/durable/file_system.hpp"

#include <algorithm>
#include <array>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace limpet {
namespace {

namespace fs = std::filesystem;

std::error_code LastTrouble() { return {errno, std::generic_category()}; }

class PosixFile final : public WritableFile {
 public:
  explicit PosixFile(int descriptor) : descriptor_(descriptor) {}
  PosixFile(const PosixFile&) = delete;
  PosixFile& operator=(const PosixFile&) = delete;
  ~PosixFile() override { ::close(descriptor_); }

  [[nodiscard]] std::error_code WriteAt(std::uint64_t offset, std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t count =
          ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) {
        continue;
      }
      if (count < 0) {
        return LastTrouble();
      }
      if (count == 0) {
        return std::make_error_code(std::errc::io_error);
      }
      bytes.remove_prefix(static_cast<std::size_t>(count));
      offset += static_cast<std::uint64_t>(count);
    }
    return {};
  }
  [[nodiscard]] std::error_code Truncate(std::uint64_t size) override {
    return ::ftruncate(descriptor_, static_cast<off_t>(size)) == 0 ? std::error_code()
                                                                   : LastTrouble();
  }
  [[nodiscard]] std::error_code Sync() override {
    // EINVAL: what a pipe or a device says; there is no disk to wait for.
    return ::fdatasync(descriptor_) == 0 || errno == EINVAL ? std::error_code() : LastTrouble();
  }
  [[nodiscard]] std::uint64_t size() const override {
    struct stat facts {};
    return ::fstat(descriptor_, &facts) == 0 ? static_cast<std::uint64_t>(facts.st_size) : 0;
  }

 private:
  int descriptor_;
};

class PosixFileSystem final : public FileSystem {
 public:
  [[nodiscard]] Opened Open(const fs::path& path, Opening how) override {
    const int mode = O_WRONLY | O_CLOEXEC | (how == Opening::kEmpty ? O_TRUNC : 0);
    Opened opened;
    int descriptor = ::open(path.c_str(), mode | O_CREAT | O_EXCL, 0644);
    opened.is_new = descriptor >= 0;
    if (descriptor < 0 && errno == EEXIST) {
      descriptor = ::open(path.c_str(), mode | O_CREAT, 0644);
    }
    if (descriptor < 0) {
      opened.trouble = LastTrouble();
    } else {
      opened.file = std::make_unique<PosixFile>(descriptor);
    }
    return opened;
  }
  [[nodiscard]] std::error_code Rename(const fs::path& from, const fs::path& to) override {
    std::error_code trouble;
    fs::rename(from, to, trouble);
    return trouble;
  }
  [[nodiscard]] std::error_code Link(const fs::path& existing, const fs::path& name) override {
    std::error_code trouble;
    fs::create_hard_link(existing, name, trouble);
    return trouble;
  }
  [[nodiscard]] std::error_code Remove(const fs::path& path) override {
    std::error_code trouble;
    fs::remove(path, trouble);
    return trouble;
  }
  [[nodiscard]] std::error_code CreateFolder(const fs::path& path) override {
    return ::mkdir(path.c_str(), 0777) == 0 ? std::error_code() : LastTrouble();
  }
  [[nodiscard]] std::error_code SyncFolder(const fs::path& path) override {
    const int folder =
        ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) {
      return LastTrouble();
    }
    const std::error_code trouble =
        ::fsync(folder) == 0 || errno == EINVAL ? std::error_code() : LastTrouble();
    ::close(folder);
    return trouble;
  }
  [[nodiscard]] std::optional<std::uint64_t> Room(const fs::path& path) const override {
    std::error_code trouble;
    const fs::space_info space = fs::space(path, trouble);
    return trouble ? std::nullopt : std::optional<std::uint64_t>(space.available);
  }
};

}  // namespace

bool IsWithoutLinks(const std::error_code& trouble) {
  // EPERM is what FAT says, and Linux of another user's file; ENOSYS comes from some of FUSE.
  return std::ranges::any_of(
      std::array{std::errc::operation_not_permitted, std::errc::not_supported,
                 std::errc::operation_not_supported, std::errc::function_not_supported,
                 std::errc::too_many_links, std::errc::cross_device_link},
      [&trouble](std::errc reason) { return trouble == reason; });
}

FileSystem& RealFileSystem() {
  static PosixFileSystem disk;
  return disk;
}

}  // namespace limpet
