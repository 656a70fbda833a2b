// SPDX-License-Identifier: MIT
#include "limpet/app/heartbeat.hpp"

#include <new>

namespace limpet {

Heartbeat::Heartbeat()
    : memory_(SharedMemory::Inherit(kVariable, sizeof(HeartbeatPage))),
      page_(static_cast<HeartbeatPage*>(memory_.data())) {}

void Heartbeat::Beat() {
  if (page_ != nullptr) {
    page_->count.store(++count_, std::memory_order_relaxed);
  }
}

void Heartbeat::Pause() {
  if (page_ != nullptr) {
    page_->count.store(0, std::memory_order_relaxed);
  }
}

HeartbeatMonitor::HeartbeatMonitor()
    : memory_(SharedMemory::Create("limpet-beat", sizeof(HeartbeatPage))) {
  if (memory_.data() != nullptr) page_ = new (memory_.data()) HeartbeatPage;
}

std::uint64_t HeartbeatMonitor::count() const {
  return page_ != nullptr ? page_->count.load(std::memory_order_relaxed) : 0;
}

void HeartbeatMonitor::Reset() {
  if (page_ != nullptr) {
    page_->count.store(0, std::memory_order_relaxed);
  }
}

}  // namespace limpet
