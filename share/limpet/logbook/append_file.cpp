// SPDX-License-Identifier: MIT
#include "limpet/logbook/append_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
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

/// Where the last line of the file's first `size` bytes ends.
std::uint64_t EndOfLines(int descriptor, std::uint64_t size) {
  std::array<char, 64 * 1024> block{};
  while (size > 0) {
    const std::uint64_t begin = size - std::min<std::uint64_t>(size, block.size());
    const auto length = static_cast<std::size_t>(size - begin);
    if (::pread(descriptor, block.data(), length, static_cast<off_t>(begin)) !=
        static_cast<ssize_t>(length)) {
      return size;
    }
    const std::size_t end = std::string_view(block.data(), length).rfind('\n');
    if (end != std::string_view::npos) {
      return begin + end + 1;
    }
    size = begin;
  }
  return 0;
}

}  // namespace

Expected<AppendFile> AppendFile::Continue(const std::filesystem::path& path) {
  AppendFile file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  const off_t size = file.descriptor_ < 0 ? -1 : ::lseek(file.descriptor_, 0, SEEK_END);
  if (size < 0) {
    return Error{fmt::format("`{}` cannot be continued: {}", path.string(),
                             std::generic_category().message(errno))};
  }
  file.size_ = static_cast<std::uint64_t>(size);
  return file;
}

Expected<AppendFile> AppendFile::ContinueLines(const std::filesystem::path& path) {
  Expected<AppendFile> file = Continue(path);
  if (file) {
    file->size_ = EndOfLines(file->descriptor_, file->size_);
    if (::ftruncate(file->descriptor_, static_cast<off_t>(file->size_)) != 0) {
      return Error{fmt::format("`{}` cannot be continued: {}", path.string(),
                               std::generic_category().message(errno))};
    }
  }
  return file;
}

Expected<AppendFile> AppendFile::Create(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    return Error{fmt::format("`{}` cannot be created: {}", path.string(),
                             std::generic_category().message(errno))};
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
