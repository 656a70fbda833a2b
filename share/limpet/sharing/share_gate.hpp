// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/sharing/secure_channel.hpp"

namespace limpet {

inline constexpr std::size_t kShareRefusals = 10;

/// In a word and in a sentence, for a person.
[[nodiscard]] std::string_view NameOf(ShareRefusal refusal);
[[nodiscard]] std::string_view MeaningOf(ShareRefusal refusal);

/// What stands behind one input: lets a datagram in as a message, or says why not. Every datagram
/// is taken for hostile.
class ShareGate {
 public:
  /// Plain if `opener` is null. An empty `white_list` lets every variable in.
  ShareGate(std::shared_ptr<Opener> opener, std::vector<std::string> white_list)
      : opener_(std::move(opener)), white_list_(std::move(white_list)) {}

  [[nodiscard]] Expected<Message, ShareRefusal> Admit(ByteView datagram);
  [[nodiscard]] bool is_plain() const { return opener_ == nullptr; }

 private:
  std::shared_ptr<Opener> opener_;
  std::vector<std::string> white_list_;
};

}  // namespace limpet
