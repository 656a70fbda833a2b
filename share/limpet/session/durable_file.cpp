// SPDX-License-Identifier: MIT
#include "limpet/session/durable_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace limpet {
namespace {

namespace fs = std::filesystem;

Error SystemError(const fs::path& file, const char* what) {
  return Error{file.filename().string() + ": " + what + ": " +
               std::generic_category().message(errno)};
}

/// A POSIX descriptor that closes itself; the standard streams cannot sync.
class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags) : value_(::open(file.c_str(), flags, 0644)) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] bool is_open() const { return value_ >= 0; }
  [[nodiscard]] bool Write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(value_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }
  [[nodiscard]] bool Sync() const { return ::fsync(value_) == 0; }

 private:
  int value_;
};

}  // namespace

std::optional<Error> SyncFolder(const fs::path& folder) {
  const Descriptor descriptor(folder, O_RDONLY | O_DIRECTORY);
  if (!descriptor.is_open() || !descriptor.Sync()) {
    return SystemError(folder, "cannot sync the folder");
  }
  return std::nullopt;
}

std::optional<Error> WriteDurably(const fs::path& file, std::string_view bytes) {
  fs::path aside = file;
  aside += ".new";
  {
    const Descriptor descriptor(aside, O_WRONLY | O_CREAT | O_TRUNC);
    if (!descriptor.is_open()) return SystemError(file, "cannot create");
    if (!descriptor.Write(bytes) || !descriptor.Sync()) {
      const Error error = SystemError(file, "cannot write");
      ::unlink(aside.c_str());
      return error;
    }
  }
  std::error_code failure;
  fs::rename(aside, file, failure);
  if (failure) {
    return Error{file.filename().string() + ": cannot rename: " + failure.message()};
  }
  return SyncFolder(file.parent_path());
}

Expected<std::string> ReadWhole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return SystemError(file, "cannot open");
  }
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace limpet
