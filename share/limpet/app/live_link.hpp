// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/app/heard_before.hpp"
#include "limpet/pubsub/tcp_client.hpp"

namespace limpet {

/// An app's link to a community on TCP. Mail arrives on the client's thread and waits here for the
/// app's own. A connection that is lost and made again shows in nothing but its gap: latest values
/// that the app has heard are not delivered again.
class LiveLink final : public AppLink {
 public:
  explicit LiveLink(TcpClientOptions options);

  void Publish(std::string name, Value value, std::string source_aux) override;
  void Forward(const Message& message) override;
  void Subscribe(const std::string& name, Seconds interval) override;
  void SubscribeWildcard(const WildcardFilter& filter) override;
  [[nodiscard]] Seconds Now() const override { return replayed_ ? *replayed_ : client_.Now(); }
  [[nodiscard]] Seconds ClockDisagreement() const override { return client_.clock_disagreement(); }
  [[nodiscard]] bool is_replaying() const override { return replayed_.has_value(); }

  /// Mail that the app heard in a former life: its like is not news when registering brings it.
  void NoteHeard(const Message& message);
  /// From now on it is `now`, and what is published goes nowhere; nothing: the present again.
  void Replay(std::optional<Seconds> now);

  /// All mail so far, waiting for some until `deadline` (steady time) if there is none.
  [[nodiscard]] std::vector<MessagePtr> TakeMail(Seconds deadline);
  /// Names of what this app has written, and of what it wants to hear.
  [[nodiscard]] const std::set<std::string>& published() const { return published_; }
  [[nodiscard]] const std::set<std::string>& subscribed() const { return subscribed_; }
  /// Ends a wait.
  void Wake() override;
  [[nodiscard]] const TcpClient& client() const { return client_; }

 private:
  TcpClientOptions Listening(TcpClientOptions options);

  std::mutex mutex_;
  std::condition_variable arrival_;
  std::vector<MessagePtr> inbox_;
  HeardBefore heard_;
  bool is_woken_ = false;
  std::set<std::string> published_, subscribed_;  ///< of the app's own thread
  std::optional<Seconds> replayed_;               ///< of the app's own thread
  TcpClient client_;  ///< last: its thread ends before what it writes to
};

}  // namespace limpet
