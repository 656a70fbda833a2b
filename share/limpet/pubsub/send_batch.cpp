// SPDX-License-Identifier: MIT
#include "limpet/pubsub/send_batch.hpp"

#include <algorithm>
#include <cerrno>

#include <liburing.h>
#include <sys/socket.h>

namespace limpet {
namespace {

constexpr unsigned kSends = 64;  ///< in one system call

}  // namespace

struct SendBatch::Ring {
  Ring() : is_open(io_uring_queue_init(kSends, &ring, 0) == 0) {}
  ~Ring() {
    if (is_open) {
      io_uring_queue_exit(&ring);
    }
  }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  io_uring ring{};
  bool is_open;
};

SendBatch::SendBatch() : ring_(std::make_unique<Ring>()) {
  if (!ring_->is_open) {
    ring_.reset();
  }
}

SendBatch::~SendBatch() = default;

void SendBatch::Add(int descriptor, ByteView bytes) { items_.push_back({descriptor, bytes}); }

std::span<const int> SendBatch::Send() {
  results_.assign(items_.size(), -EAGAIN);
  for (std::size_t at = 0; at < items_.size() && ring_; at += kSends) {
    const std::size_t count = std::min<std::size_t>(kSends, items_.size() - at);
    if (!SendSome(std::span(items_).subspan(at, count), std::span(results_).subspan(at, count))) {
      ring_.reset();
    }
  }
  items_.clear();
  return results_;
}

bool SendBatch::SendSome(std::span<const Item> items, std::span<int> results) {
  io_uring& ring = ring_->ring;
  for (std::size_t i = 0; i < items.size(); ++i) {
    io_uring_sqe* const entry = io_uring_get_sqe(&ring);
    // MSG_DONTWAIT: done, one way or the other, when the call returns; no worker takes it over.
    io_uring_prep_send(entry, items[i].descriptor, items[i].bytes.data(), items[i].bytes.size(),
                       MSG_NOSIGNAL | MSG_DONTWAIT);
    entry->user_data = i;
  }
  const int handed_over = io_uring_submit_and_wait(&ring, static_cast<unsigned>(items.size()));
  for (int i = 0; i < handed_over; ++i) {
    io_uring_cqe* result = nullptr;
    while (io_uring_wait_cqe(&ring, &result) == -EINTR) {
    }
    if (result == nullptr) {
      return false;
    }
    results[result->user_data] = result->res;
    io_uring_cqe_seen(&ring, result);
  }
  return handed_over == static_cast<int>(items.size());
}

}  // namespace limpet
