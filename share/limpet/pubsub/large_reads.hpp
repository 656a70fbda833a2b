// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "limpet/pubsub/connection_order.hpp"
#include "limpet/pubsub/held_memory.hpp"

namespace limpet {

/// The order in which large packets are read: one by one, each to its end if its bytes are there,
/// a piece between two looks at all sockets. Short messages of others then wait for one piece, not
/// for all packets. While memory is getting short they come in slowly: what is never whole must not
/// cost others their share of the processor. A packet that may not grow waits until there is room.
class LargeReads {
 public:
  using Connection = Connections::iterator;
  struct Owner {
    std::function<UnitReader::End(Connection)> read;  ///< and closes it if need be
    std::function<void(Connection)> wait;             ///< until there is more to read
    std::function<bool()> make_room;                  ///< false: there is none to be made now
  };
  LargeReads(asio::io_context& context, const HeldMemory& memory, Owner owner)
      : context_(context),
        memory_(memory),
        owner_(std::move(owner)),
        timer_(context),
        pause_(context) {}

  /// A connection amid a large packet has bytes.
  void Add(Connection connection);
  /// What is next for a connection that has just been read.
  void Continue(Connection connection, UnitReader::End end);
  /// The connection is closed.
  void Remove(Connection connection);

 private:
  void ReadOn();
  void ReadOne();
  void FeedStarved();

  asio::io_context& context_;
  const HeldMemory& memory_;
  Owner owner_;
  asio::steady_timer timer_;  ///< until the starved are looked at again
  asio::steady_timer pause_;
  std::deque<Connection> readable_;
  std::deque<Connection> starved_;
  bool is_reading_ = false;
  bool is_feeding_ = false;  ///< timer_ is running
};

}  // namespace limpet
