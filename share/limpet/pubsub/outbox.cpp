// SPDX-License-Identifier: MIT
#include "limpet/pubsub/outbox.hpp"

#include <algorithm>

namespace limpet {
namespace {

constexpr std::uint32_t kDropped = 0x8000'0000U;  // no message is that large

}  // namespace

void Outbox::Append(Router::Variable variable, ByteView message) {
  Enter(variable, message.size());
  parcel_.Append(message);
}

void Outbox::Append(Router::Variable variable, const SharedBytes& message) {
  Enter(variable, message->size());
  parcel_.Append(message);
}

void Outbox::Enter(Router::Variable variable, std::size_t size) {
  if (in_flight_ + parcel_.size() + size > limit_) {
    MakeRoom(variable, size);
  }
  entries_.push_back({variable, static_cast<std::uint32_t>(size)});
}

void Outbox::MakeRoom(Router::Variable variable, std::size_t size) {
  const std::size_t held = in_flight_ + parcel_.size() + size;
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

void Outbox::DropOlderHalf() {
  const std::size_t wanted = parcel_.size() / 2;
  std::size_t freed = 0;
  for (Entry& entry : entries_) {
    if (freed > wanted) {
      break;
    }
    freed += entry.size;
    entry.size |= kDropped;
    ++dropped_;
  }
  Compact();
  entries_.shrink_to_fit();
}

void Outbox::Compact() {
  parcel_.Drop([this](std::size_t i) { return entries_[i].size & ~kDropped; },
               [this](std::size_t i) { return (entries_[i].size & kDropped) != 0; });
  std::erase_if(entries_, [](const Entry& entry) { return (entry.size & kDropped) != 0; });
}

std::size_t Outbox::Take(Parcel& parcel) {
  const std::size_t count = entries_.size();
  parcel.Clear();
  std::swap(parcel, parcel_);
  entries_.clear();
  return count;
}

void Outbox::Clear() {
  parcel_ = {};
  entries_ = {};
}

void Outbox::GiveBack() {
  if (entries_.empty()) {
    parcel_.GiveBack();
    entries_ = {};
  }
}

}  // namespace limpet
