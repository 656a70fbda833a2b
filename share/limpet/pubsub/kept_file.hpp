// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// Encoded messages in a file that outlives the process, usually one in memory that a launcher
/// holds open. Whatever instant the process is killed at, what was appended before is there again:
/// a message counts once the header says so, in one write. Two halves, so that a rewrite is
/// complete before it takes the place of the former content. It survives the process, not the
/// machine: nothing is brought to a disk. Not thread-safe.
class KeptFile {
 public:
  /// `descriptor` stays the caller's. Each half holds up to `limit` bytes.
  KeptFile(int descriptor, std::size_t limit);

  /// What is kept, oldest first, back to back; empty if the file is new or not one of ours.
  [[nodiscard]] ByteBuffer Load() const;
  /// False if there is no room for it, or the file cannot be written.
  [[nodiscard]] bool Append(ByteView messages);
  /// Replaces everything. False if there is no room for it, or the file cannot be written.
  [[nodiscard]] bool Rewrite(ByteView messages);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t limit() const { return limit_; }

 private:
  [[nodiscard]] bool ReadHeader();
  [[nodiscard]] bool WriteHeader(std::uint32_t half, std::size_t size);
  [[nodiscard]] std::int64_t PlaceOf(std::uint32_t half) const;

  int descriptor_;
  std::size_t limit_;
  std::uint32_t half_ = 0;  ///< the one that counts
  std::size_t size_ = 0;    ///< of what counts in it [bytes]
};

}  // namespace limpet
