// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "limpet/sharing/replay_window.hpp"
#include "limpet/sharing/secure_channel.hpp"

namespace limpet {

/// Lets sealed datagrams in: each once, only if it is for this receiver, and only while it is
/// young. How old one is, it knows by asking its sender for the time, once for each start of a
/// sender and then now and then: the sender's clock may be an hour off. Of one that does not answer
/// (a link that goes one way only) the clocks must agree. Nothing is kept on a disk: what was
/// sealed before this receiver's start is too old. All inputs under one key share one guard.
class ShareGuard {
 public:
  static constexpr std::size_t kMostSenders = 1000;
  static constexpr std::size_t kMostWaiting = 256;  ///< for their sender's answer

  struct Settings {
    std::uint64_t receiver = 0;  ///< whom datagrams for this node are sealed to
    Seconds max_age{5.0};
  };
  /// `sealer`: of this node, under the same key; it seals the questions.
  ShareGuard(const ShareKey& key, Settings settings, std::shared_ptr<Sealer> sealer,
             ShareInstant now);

  struct Verdict {
    std::vector<ByteBuffer> bodies;  ///< plain datagrams that are let in
    std::optional<ShareRefusal> refusal{};
    std::optional<ByteBuffer> reply{};  ///< to be sent back to where the datagram came from
  };
  /// `channel`: of a multicast input, whose datagrams are for whoever listens; 0: none.
  [[nodiscard]] Verdict Judge(ByteView datagram, std::uint64_t channel, ShareInstant now);
  /// How many have waited in vain for their sender's answer, since the last call.
  [[nodiscard]] std::size_t TakeGivenUp(ShareInstant now);
  /// The answer to a question that came to where this node sends from; nothing if it is none.
  [[nodiscard]] std::optional<ByteBuffer> Answer(ByteView datagram, ShareInstant now);

 private:
  struct Question {
    std::uint64_t word = 0;
    Seconds asked;  ///< steady
  };
  /// One run of a sender.
  struct Sender {
    ReplayWindow window;
    /// Steady time here when it started, at the earliest: found by asking.
    std::optional<Seconds> start;
    Seconds measured{};
    std::optional<Question> question;
    Seconds pause{};  ///< to the next question, if this one is not answered
    Seconds heard{};
  };
  struct Waiting {
    SealedContent content;
    Seconds since;
  };

  void TakeData(SealedContent content, ShareInstant now, Verdict& verdict);
  void TakeAnswer(const SealedContent& content, ShareInstant now, Verdict& verdict);
  /// Young and new: a body. Otherwise the reason.
  void Settle(Sender& sender, SealedContent content, Seconds age, ShareInstant now,
              Verdict& verdict);
  void Ask(Sender& sender, const ShareRun& run, ShareInstant now, Verdict& verdict) const;
  /// The greatest age that is let in.
  [[nodiscard]] Seconds Oldest(ShareInstant now) const;
  [[nodiscard]] Sender* Find(const ShareRun& run, ShareInstant now);

  ShareKey key_;
  Settings settings_;
  std::shared_ptr<Sealer> sealer_;
  Seconds start_;
  std::map<ShareRun, Sender> senders_;
  std::vector<Waiting> waiting_;
};

}  // namespace limpet
