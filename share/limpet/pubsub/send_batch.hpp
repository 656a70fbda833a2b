// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// Sends to several sockets in one system call (io_uring). Each send wakes a reader, who may take
/// the sender's place on its core: sent one by one, the last reader waits for all others to have
/// read. Not thread-safe.
class SendBatch {
 public:
  SendBatch();
  ~SendBatch();
  SendBatch(const SendBatch&) = delete;
  SendBatch& operator=(const SendBatch&) = delete;

  /// False where the system is too old for it, or forbids it: then it sends nothing.
  [[nodiscard]] bool is_open() const { return ring_ != nullptr; }

  /// `bytes` must stay until Send() has returned.
  void Add(int descriptor, ByteView bytes);
  /// Sends what was added since the last call, as much as each socket takes at once. Gives, in the
  /// order of Add, the bytes taken or an errno, negative (-EAGAIN also if it was not tried); valid
  /// until the next Send.
  [[nodiscard]] std::span<const int> Send();

 private:
  struct Ring;
  struct Item {
    int descriptor;
    ByteView bytes;
  };
  /// False if the ring is not to be used again.
  [[nodiscard]] bool SendSome(std::span<const Item> items, std::span<int> results);

  std::unique_ptr<Ring> ring_;  ///< nothing: not open
  std::vector<Item> items_;
  std::vector<int> results_;
};

}  // namespace limpet
