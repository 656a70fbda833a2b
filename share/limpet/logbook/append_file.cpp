// SPDX-License-Identifier: MIT
#include "limpet/logbook/append_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

bool WriteAllAt(int descriptor, std::string_view bytes, std::uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t count =
        ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
  return true;
}

}  // namespace

Expected<AppendFile> AppendFile::Create(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    return Error{fmt::format("`{}` cannot be created: {}", path.string(), std::strerror(errno))};
  }
  return AppendFile(descriptor);
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      is_synced_(other.is_synced_) {}

AppendFile& AppendFile::operator=(AppendFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  std::swap(is_synced_, other.is_synced_);
  return *this;
}

AppendFile::~AppendFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

bool AppendFile::Append(std::string_view bytes) {
  if (!WriteAllAt(descriptor_, bytes, size_)) {
    // If even this fails, the next piece is still written from size_ on, over the remains.
    [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, static_cast<off_t>(size_));
    return false;
  }
  size_ += bytes.size();
  is_synced_ = is_synced_ && bytes.empty();
  return true;
}

bool AppendFile::Overwrite(std::uint64_t offset, std::string_view bytes) {
  LIMPET_REQUIRE(offset + bytes.size() <= size_, "only what is there can be written over");
  is_synced_ = false;
  return WriteAllAt(descriptor_, bytes, offset);
}

bool AppendFile::Sync() {
  if (is_synced_) {
    return true;
  }
  // EINVAL: what a pipe or a device says; there is no disk to wait for.
  is_synced_ = ::fdatasync(descriptor_) == 0 || errno == EINVAL;
  return is_synced_;
}

void SyncFileNames(const std::filesystem::path& folder) {
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
}

}  // namespace limpet
