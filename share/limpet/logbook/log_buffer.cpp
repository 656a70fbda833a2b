// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_buffer.hpp"

#include <fmt/format.h>

namespace limpet {

void LogBuffer::NoteDropped() {
  ++losses_.dropped;
  ++unsaid_;
}

bool LogBuffer::HandOver() {
  if (unsaid_ > 0) {
    if (!file_.Append(fmt::format("%% {} messages are missing here: the disk did not take them\n",
                                  unsaid_))) {
      return false;
    }
    unsaid_ = 0;
  }
  if (!file_.Append(text_)) {
    return false;
  }
  unsynced_ += losses_.waiting;
  losses_.waiting = 0;
  text_.clear();
  return true;
}

bool LogBuffer::Flush() {
  const bool is_good = HandOver();
  trouble_ = is_good ? std::error_code() : file_.trouble();
  if (!is_good && text_.size() > kMostBytesKept) {
    losses_.dropped += losses_.waiting;
    unsaid_ += losses_.waiting;
    losses_.waiting = 0;
    text_.clear();
  }
  return is_good;
}

bool LogBuffer::Sync() {
  const bool is_handed_over = Flush();
  if (!file_.Sync()) {
    trouble_ = file_.trouble();
    losses_.in_doubt += unsynced_;
    unsynced_ = 0;
    return false;
  }
  unsynced_ = 0;
  return is_handed_over;
}

}  // namespace limpet
