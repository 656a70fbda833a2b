// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/sharing/share_guard.hpp"

namespace limpet {

inline constexpr std::size_t kShareRefusals = 12;

/// The refusal in a word and in a sentence, for a person.
[[nodiscard]] std::string_view NameOf(ShareRefusal refusal);
[[nodiscard]] std::string_view MeaningOf(ShareRefusal refusal);

/// What becomes of a datagram, and of those that have waited for it.
struct ShareAdmission {
  std::vector<Message> messages;
  std::vector<ShareRefusal> refusals;
  std::optional<ByteBuffer> reply;  ///< to be sent back to where it came from
};

/// What stands behind one input: lets a datagram in as a message, or says why not. Every datagram
/// is taken for hostile.
class ShareGate {
 public:
  using WhiteList = std::vector<std::string>;
  /// Plain if `guard` is null. A variable must be on each of the lists; an empty one holds all.
  /// `channel`: as ShareGuard::Judge takes it.
  ShareGate(std::shared_ptr<ShareGuard> guard, std::vector<WhiteList> white_lists,
            std::uint64_t channel = 0)
      : guard_(std::move(guard)), white_lists_(std::move(white_lists)), channel_(channel) {}

  [[nodiscard]] ShareAdmission Admit(ByteView datagram, ShareInstant now);

 private:
  void AdmitPlain(ByteView datagram, ShareAdmission& admission) const;

  std::shared_ptr<ShareGuard> guard_;
  std::vector<WhiteList> white_lists_;
  std::uint64_t channel_;
};

}  // namespace limpet
