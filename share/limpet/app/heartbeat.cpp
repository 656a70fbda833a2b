// SPDX-License-Identifier: MIT
#include "limpet/app/heartbeat.hpp"

#include <cstdlib>
#include <new>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

HeartbeatPage* MapPage(int descriptor) {
  struct stat facts {};
  if (descriptor < 0 || ::fstat(descriptor, &facts) != 0 ||
      facts.st_size < static_cast<off_t>(sizeof(HeartbeatPage))) {
    return nullptr;
  }
  void* memory =
      ::mmap(nullptr, sizeof(HeartbeatPage), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  return memory == MAP_FAILED ? nullptr : static_cast<HeartbeatPage*>(memory);
}

void UnmapPage(HeartbeatPage* page) {
  if (page != nullptr) {
    ::munmap(page, sizeof(HeartbeatPage));
  }
}

}  // namespace

Heartbeat::Heartbeat() {
  const char* text = std::getenv("LIMPET_BEAT_FD");  // NOLINT(concurrency-mt-unsafe): no thread yet
  const auto number = ParseInteger(text != nullptr ? text : "");
  if (number && *number > STDERR_FILENO) {
    const int descriptor = static_cast<int>(*number);
    page_ = MapPage(descriptor);
    if (page_ != nullptr) {
      ::close(descriptor);
      ::unsetenv("LIMPET_BEAT_FD");  // NOLINT(concurrency-mt-unsafe): programs below us do not beat
    }
  }
}

Heartbeat::~Heartbeat() {
  Pause();
  UnmapPage(page_);
}

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

HeartbeatMonitor::HeartbeatMonitor() : descriptor_(::memfd_create("limpet-beat", MFD_CLOEXEC)) {
  if (descriptor_ >= 0 && ::ftruncate(descriptor_, sizeof(HeartbeatPage)) == 0) {
    page_ = MapPage(descriptor_);
  }
  if (page_ != nullptr) {
    new (page_) HeartbeatPage;
  }
}

HeartbeatMonitor::~HeartbeatMonitor() {
  UnmapPage(page_);
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

HeartbeatMonitor::HeartbeatMonitor(HeartbeatMonitor&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      page_(std::exchange(other.page_, nullptr)) {}

std::uint64_t HeartbeatMonitor::count() const {
  return page_ != nullptr ? page_->count.load(std::memory_order_relaxed) : 0;
}

void HeartbeatMonitor::Reset() {
  if (page_ != nullptr) {
    page_->count.store(0, std::memory_order_relaxed);
  }
}

}  // namespace limpet
