// SPDX-License-Identifier: MIT
#include "limpet/runs/folder_lock.hpp"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"

namespace limpet {
namespace {

/// What the holder has left about itself; only for the complaint.
std::string HolderIn(int file) {
  std::array<char, 32> bytes{};
  const ssize_t count = ::pread(file, bytes.data(), bytes.size(), 0);
  const std::string text(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  const std::string digits = text.substr(0, text.find_first_not_of("0123456789"));
  return digits.empty() ? "" : fmt::format(" (process {})", digits);
}

std::string Cause() { return std::generic_category().message(errno); }

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kFile;
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (file_ < 0) {
    throw std::runtime_error(fmt::format("cannot lock {}: {}", OneLine(folder.string()), Cause()));
  }
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const bool is_held = errno == EWOULDBLOCK;
    const std::string text =
        is_held ? fmt::format("{} is in use by another run{}; wait for it, or choose another --out",
                              OneLine(folder.string()), HolderIn(file_))
                : fmt::format("cannot lock {}: {}", OneLine(folder.string()), Cause());
    ::close(file_);
    if (is_held) throw Refusal(text);
    throw std::runtime_error(text);
  }
  const std::string holder = fmt::format("{}\n", ::getpid());
  // The text only helps a person; the lock is the kernel's.
  if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, holder.data(), holder.size(), 0) < 0) return;
}

FolderLock::~FolderLock() {
  // The file stays, empty: another process may already wait on it.
  if (::ftruncate(file_, 0) != 0) errno = 0;
  ::close(file_);
}

}  // namespace limpet
