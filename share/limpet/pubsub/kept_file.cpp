// SPDX-License-Identifier: MIT
#include "limpet/pubsub/kept_file.hpp"

#include <array>

#include <fcntl.h>
#include <unistd.h>

#include "limpet/wire/little_endian.hpp"

namespace limpet {
namespace {

constexpr std::uint32_t kMagic = 0x3154504b;  // "KPT1"
constexpr std::size_t kHeaderSize = 16;       // magic, half, size
constexpr std::int64_t kFirstHalf = 4096;     // a page of its own for the header

bool WriteAll(int descriptor, ByteView bytes, std::int64_t place) {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor, bytes.data(), bytes.size(), place);
    if (count <= 0) {
      return false;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    place += count;
  }
  return true;
}

}  // namespace

KeptFile::KeptFile(int descriptor, std::size_t limit) : descriptor_(descriptor), limit_(limit) {
  if (!ReadHeader()) {
    half_ = 0;
    size_ = 0;
  }
}

std::int64_t KeptFile::PlaceOf(std::uint32_t half) const {
  return kFirstHalf + static_cast<std::int64_t>(half) * static_cast<std::int64_t>(limit_);
}

bool KeptFile::ReadHeader() {
  std::array<std::byte, kHeaderSize> header{};
  if (::pread(descriptor_, header.data(), header.size(), 0) != kHeaderSize ||
      Get<std::uint32_t>(header.data()) != kMagic) {
    return false;
  }
  half_ = Get<std::uint32_t>(header.data() + 4);
  size_ = Get<std::uint64_t>(header.data() + 8);
  return half_ <= 1 && size_ <= limit_;
}

bool KeptFile::WriteHeader(std::uint32_t half, std::size_t size) {
  std::array<std::byte, kHeaderSize> header{};
  Put(Put(Put(header.data(), kMagic), half), static_cast<std::uint64_t>(size));
  if (!WriteAll(descriptor_, header, 0)) {
    return false;
  }
  half_ = half;
  size_ = size;
  return true;
}

ByteBuffer KeptFile::Load() const {
  ByteBuffer messages(size_);
  std::size_t filled = 0;
  while (filled < size_) {
    const ssize_t count = ::pread(descriptor_, messages.data() + filled, size_ - filled,
                                  PlaceOf(half_) + static_cast<std::int64_t>(filled));
    if (count <= 0) {
      break;
    }
    filled += static_cast<std::size_t>(count);
  }
  messages.resize(filled);
  return messages;
}

bool KeptFile::Append(ByteView messages) {
  return size_ + messages.size() <= limit_ &&
         WriteAll(descriptor_, messages, PlaceOf(half_) + static_cast<std::int64_t>(size_)) &&
         WriteHeader(half_, size_ + messages.size());
}

bool KeptFile::Rewrite(ByteView messages) {
  const std::uint32_t former = half_;
  if (messages.size() > limit_ || !WriteAll(descriptor_, messages, PlaceOf(1 - former)) ||
      !WriteHeader(1 - former, messages.size())) {
    return false;
  }
  // The former half's memory goes back; a file system that cannot do that merely keeps it.
  static_cast<void>(::fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                                PlaceOf(former), static_cast<std::int64_t>(limit_)));
  return true;
}

}  // namespace limpet
