// SPDX-License-Identifier: MIT
#include "limpet/pubsub/outbox.hpp"

#include <algorithm>
#include <cstring>

namespace limpet {
namespace {

constexpr std::uint32_t kDropped = 0x8000'0000U;  // no message is that large

}  // namespace

void Outbox::Append(Router::Variable variable, ByteView message) {
  if (in_flight_ + bytes_.size() + message.size() > limit_) {
    MakeRoom(variable, message.size());
  }
  bytes_.insert(bytes_.end(), message.begin(), message.end());
  entries_.push_back({variable, static_cast<std::uint32_t>(message.size())});
}

void Outbox::MakeRoom(Router::Variable variable, std::size_t size) {
  const std::size_t held = in_flight_ + bytes_.size() + size;
  const std::size_t wanted = held - std::min(held, limit_) + limit_ / 8;
  std::size_t freed = 0;
  const auto drop_oldest = [&](auto may_go) {
    for (Entry& entry : entries_) {
      if (freed >= wanted) {
        return;
      }
      if ((entry.size & kDropped) == 0 && may_go(entry)) {
        freed += entry.size;
        entry.size |= kDropped;
        ++dropped_;
      }
    }
  };
  drop_oldest([variable](const Entry& entry) { return entry.variable == variable; });
  if (held - freed > limit_) {
    drop_oldest([](const Entry& entry) { return entry.variable != kNoVariable; });
  }
  Compact();
}

void Outbox::Compact() {
  std::byte* to = bytes_.data();
  const std::byte* from = bytes_.data();
  for (const Entry& entry : entries_) {
    const std::size_t size = entry.size & ~kDropped;
    if ((entry.size & kDropped) == 0) {
      std::memmove(to, from, size);
      to += size;
    }
    from += size;
  }
  bytes_.resize(static_cast<std::size_t>(to - bytes_.data()));
  std::erase_if(entries_, [](const Entry& entry) { return (entry.size & kDropped) != 0; });
}

std::size_t Outbox::Take(ByteBuffer& body) {
  const std::size_t count = entries_.size();
  body.clear();
  body.swap(bytes_);
  entries_.clear();
  return count;
}

void Outbox::Clear() {
  bytes_ = {};
  entries_ = {};
}

}  // namespace limpet
