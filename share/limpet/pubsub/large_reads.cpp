// SPDX-License-Identifier: MIT
#include "limpet/pubsub/large_reads.hpp"

#include <asio/post.hpp>

namespace limpet {
namespace {

constexpr auto kPause = std::chrono::milliseconds(1);
constexpr auto kStarvedPeriod = std::chrono::milliseconds(20);

}  // namespace

void LargeReads::Add(Connection connection) {
  readable_.push_back(connection);
  ReadOn();
}

void LargeReads::Continue(Connection connection, UnitReader::End end) {
  if (end == UnitReader::End::kStarved) {
    starved_.push_back(connection);
    FeedStarved();
  } else if (end == UnitReader::End::kMore && connection->is_large()) {
    Add(connection);
  } else if (end != UnitReader::End::kClosed) {
    owner_.wait(connection);
  }
}

void LargeReads::Remove(Connection connection) {
  std::erase(readable_, connection);
  std::erase(starved_, connection);
}

void LargeReads::ReadOn() {
  if (is_reading_ || readable_.empty()) {
    return;
  }
  is_reading_ = true;
  if (!memory_.IsGettingShort()) {
    asio::post(context_, [this] { ReadOne(); });
    return;
  }
  // More comes than is ever whole: worked off as fast as it comes it would take the processor from
  // everybody else.
  pause_.expires_after(kPause);
  pause_.async_wait([this](std::error_code error) {
    if (!error) {
      ReadOne();
    }
  });
}

void LargeReads::ReadOne() {
  is_reading_ = false;
  if (!readable_.empty()) {
    const Connection connection = readable_.front();
    const UnitReader::End end = owner_.read(connection);
    if (end != UnitReader::End::kMore || !connection->is_large()) {
      std::erase(readable_, connection);
      Continue(connection, end);
    }
  }
  FeedStarved();
  ReadOn();
}

void LargeReads::FeedStarved() {
  while (!starved_.empty()) {
    const Connection connection = starved_.front();
    const auto is_still_first = [&] { return !starved_.empty() && starved_.front() == connection; };
    bool has_room = memory_.HasRoomFor(connection->wanted());
    while (!has_room && owner_.make_room() && is_still_first()) {
      has_room = memory_.HasRoomFor(connection->wanted());
    }
    if (!is_still_first()) {
      continue;  // it was the one that had to go
    }
    if (!has_room) {
      break;
    }
    starved_.pop_front();
    Add(connection);
  }
  if (!starved_.empty() && !is_feeding_) {
    is_feeding_ = true;
    timer_.expires_after(kStarvedPeriod);
    timer_.async_wait([this](std::error_code error) {
      is_feeding_ = false;
      if (!error) {
        FeedStarved();
      }
    });
  }
}

}  // namespace limpet
