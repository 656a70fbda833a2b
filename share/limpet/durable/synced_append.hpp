// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "limpet/durable/append_file.hpp"
#include "limpet/durable/sync_timer.hpp"

namespace limpet {

/// A file that grows and is on the disk within the sync interval, if whoever writes it comes when
/// it is due. It reads no clock.
class SyncedAppend {
 public:
  using Time = SyncTimer::Clock::time_point;
  SyncedAppend(AppendFile file, std::chrono::milliseconds interval, Time now)
      : file_(std::move(file)), timer_(interval, now) {
    timer_.NoteWrite();  // the file itself is new, or was cut
  }

  /// Appends and syncs what is due; `bytes` may be empty. False after trouble.
  [[nodiscard]] bool Write(std::string_view bytes, Time now);
  [[nodiscard]] bool Sync() { return file_.Sync(); }
  void Discard() { file_.Discard(); }
  /// When to come again if nothing is to be written before.
  [[nodiscard]] std::optional<Time> due() const { return timer_.due(); }
  [[nodiscard]] std::error_code trouble() const { return file_.trouble(); }

 private:
  AppendFile file_;
  SyncTimer timer_;
};

}  // namespace limpet
