// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

namespace limpet {

/// The one budget for memory that a broker holds for others: packets that have not arrived whole,
/// and mail that its readers have not taken. Either may use all of it while the other needs none;
/// when it is short, packets are sure of three quarters (of the largest one, by default), mail of
/// one. Latest values are not in it: they have a limit of their own. Not thread-safe.
class HeldMemory {
 public:
  explicit HeldMemory(std::size_t limit) : limit_(limit) {}

  [[nodiscard]] std::size_t limit() const { return limit_; }
  [[nodiscard]] std::size_t unfinished() const { return unfinished_; }
  [[nodiscard]] std::size_t queued() const { return queued_; }

  void ResizeUnfinished(std::size_t from, std::size_t to) { unfinished_ += to - from; }
  void SetQueued(std::size_t bytes) { queued_ = bytes; }

  /// Whether unfinished packets may take that much more.
  [[nodiscard]] bool HasRoomFor(std::size_t more) const {
    return unfinished_ + more + std::min(queued_, limit_ / 4) <= limit_;
  }
  /// True if unfinished packets take more than on most days.
  [[nodiscard]] bool IsGettingShort() const { return unfinished_ > limit_ / 8; }
  /// What mail may take now.
  [[nodiscard]] std::size_t RoomForMail() const {
    return limit_ - std::min(unfinished_, limit_ / 4 * 3);
  }
  /// True if unfinished packets must give way.
  [[nodiscard]] bool IsUnfinishedTooMuch() const {
    return unfinished_ > limit_ / 4 * 3 && unfinished_ + queued_ > limit_;
  }

 private:
  std::size_t limit_;
  std::size_t unfinished_ = 0;
  std::size_t queued_ = 0;  ///< at the last count
};

}  // namespace limpet
