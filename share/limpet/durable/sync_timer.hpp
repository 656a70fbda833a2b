// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>

namespace limpet {

/// When what was written is to be brought to the disk, so that a power cut costs less than a second
/// of it. It reads no clock.
class SyncTimer {
 public:
  using Clock = std::chrono::steady_clock;
  /// Half of the second that a power cut may cost: the other half is for the disk.
  static constexpr std::chrono::milliseconds kInterval{500};

  SyncTimer(std::chrono::milliseconds interval, Clock::time_point now)
      : interval_(interval), last_(now) {}

  void NoteWrite() { has_unsynced_ = true; }
  void NoteSync(Clock::time_point now) {
    last_ = now;
    has_unsynced_ = false;
  }
  [[nodiscard]] bool IsDue(Clock::time_point now) const {
    return has_unsynced_ && now - last_ >= interval_;
  }
  /// Nothing while everything is on the disk.
  [[nodiscard]] std::optional<Clock::time_point> due() const {
    return has_unsynced_ ? std::optional(last_ + interval_) : std::nullopt;
  }

 private:
  std::chrono::milliseconds interval_;
  Clock::time_point last_;
  bool has_unsynced_ = false;
};

}  // namespace limpet
