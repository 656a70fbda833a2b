// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_key.hpp"

#include <cerrno>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limpet/core/config.hpp"
#include "limpet/sharing/sodium_start.hpp"

namespace limpet {
namespace {

constexpr std::string_view kForm = "limpet-key-1";
constexpr std::size_t kLargestFile = 4096;
constexpr mode_t kOthers = S_IRWXG | S_IRWXO;

std::string Hex(const unsigned char* bytes, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("{:02x}", bytes[i]);
  }
  return text;
}

/// Closes what it holds.
class File {
 public:
  File(const std::filesystem::path& path, int flags, mode_t mode = 0)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  ~File() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

Error SystemError(const std::filesystem::path& file) {
  return Error{fmt::format("{}: {}", file.string(), std::generic_category().message(errno))};
}

/// Why a file must not be trusted with a key.
std::optional<Error> Distrust(const std::filesystem::path& file, const struct stat& facts) {
  if (!S_ISREG(facts.st_mode)) {
    return Error{fmt::format("{} is no regular file", file.string())};
  }
  if (facts.st_uid != ::geteuid() && facts.st_uid != 0) {
    return Error{fmt::format("{} belongs to another user", file.string())};
  }
  if ((facts.st_mode & kOthers) != 0) {
    return Error{
        fmt::format("{} is open to other users: chmod 600 {}", file.string(), file.string())};
  }
  return std::nullopt;
}

Expected<std::string> ReadAll(const std::filesystem::path& path, const File& file) {
  std::string text(kLargestFile + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t count = ::read(file.descriptor(), text.data() + size, text.size() - size);
    if (count < 0) {
      return SystemError(path);
    }
    if (count == 0) {
      break;
    }
    size += static_cast<std::size_t>(count);
  }
  if (size > kLargestFile) {
    return Error{"the file is too large to be a key"};
  }
  text.resize(size);
  return text;
}

}  // namespace

ShareKey::~ShareKey() { sodium_memzero(bytes_.data(), bytes_.size()); }

ShareKey ShareKey::Random() {
  StartSodium();
  Bytes bytes;
  randombytes_buf(bytes.data(), bytes.size());
  return ShareKey(bytes);
}

Expected<ShareKey> ShareKey::Parse(std::string_view text) {
  StartSodium();
  for (const std::string& raw : Split(text, '\n')) {
    const std::string_view line = Trim(raw);
    if (line.empty() || line.starts_with('#')) {
      continue;
    }
    const std::vector<std::string> words = Split(line, ' ');
    Bytes bytes{};
    std::size_t size = 0;
    if (words.size() != 3 || words[0] != kForm || words[1].size() != 2 * kShareKeySize ||
        sodium_hex2bin(bytes.data(), bytes.size(), words[1].data(), words[1].size(), nullptr, &size,
                       nullptr) != 0 ||
        size != kShareKeySize) {
      return Error{fmt::format("not of the form `{} <{} hexadecimal digits> <fingerprint>`", kForm,
                               2 * kShareKeySize)};
    }
    ShareKey key(bytes);
    sodium_memzero(bytes.data(), bytes.size());
    if (key.Fingerprint() != words[2]) {
      return Error{"the key does not have its fingerprint: a digit is wrong"};
    }
    return key;
  }
  return Error{"there is no key in it"};
}

std::string ShareKey::Text() const {
  return fmt::format(
      "# Limpet key for pShare. Whoever has it reads and speaks on every route sealed with it.\n"
      "{} {} {}\n",
      kForm, Hex(bytes_.data(), bytes_.size()), Fingerprint());
}

std::string ShareKey::Fingerprint() const {
  StartSodium();
  std::array<unsigned char, crypto_generichash_BYTES_MIN> digest{};
  constexpr std::string_view kPurpose = "limpet key fingerprint";
  crypto_generichash(digest.data(), digest.size(),
                     reinterpret_cast<const unsigned char*>(kPurpose.data()), kPurpose.size(),
                     bytes_.data(), bytes_.size());
  return Hex(digest.data(), 4);
}

Expected<ShareKey> LoadShareKey(const std::filesystem::path& path) {
  // Without O_NONBLOCK a pipe in place of the file would keep us waiting for a writer.
  const File file(path, O_RDONLY | O_NONBLOCK);
  struct stat facts {};
  if (!file.is_open() && errno == ENOENT) {
    return Error{fmt::format("{} does not exist; `limpet key new {}` makes it", path.string(),
                             path.string())};
  }
  if (!file.is_open() || ::fstat(file.descriptor(), &facts) != 0) {
    return SystemError(path);
  }
  if (auto distrust = Distrust(path, facts)) {
    return *distrust;
  }
  auto text = ReadAll(path, file);
  if (!text) {
    return text.error();
  }
  auto key = ShareKey::Parse(*text);
  sodium_memzero(text->data(), text->size());
  return key ? key : Error{fmt::format("{}: {}", path.string(), key.error().text)};
}

std::optional<Error> SaveShareKey(const ShareKey& key, const std::filesystem::path& path) {
  const File file(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, S_IRUSR | S_IWUSR);
  if (!file.is_open()) {
    return SystemError(path);
  }
  std::string text = key.Text();
  const ssize_t count = ::write(file.descriptor(), text.data(), text.size());
  const bool is_whole = count == static_cast<ssize_t>(text.size());
  sodium_memzero(text.data(), text.size());
  if (!is_whole || ::fsync(file.descriptor()) != 0) {
    const Error error = SystemError(path);
    ::unlink(path.c_str());
    return error;
  }
  return std::nullopt;
}

}  // namespace limpet
