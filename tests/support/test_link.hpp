// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"

namespace limpet {

/// Runs one app without a database: tests hand it mail and read what it published.
class TestLink final : public AppLink {
 public:
  void Publish(std::string name, Value value, std::string source_aux) override {
    published.push_back(std::make_shared<const Message>(Message{.name = std::move(name),
                                                                .value = std::move(value),
                                                                .time = time,
                                                                .source = "test",
                                                                .source_aux = std::move(source_aux),
                                                                .community = ""}));
  }
  void Forward(const Message& message) override {
    published.push_back(std::make_shared<const Message>(message));
  }
  void Subscribe(const std::string& name, Seconds) override { subscriptions.push_back(name); }
  void SubscribeWildcard(const WildcardFilter& filter) override {
    subscriptions.push_back(filter.variable_pattern);
  }
  [[nodiscard]] Seconds Now() const override { return time; }
  [[nodiscard]] Seconds ClockDisagreement() const override { return clock_disagreement; }
  [[nodiscard]] bool is_replaying() const override { return replays; }

  /// Last value published on a topic.
  template <class T>
  [[nodiscard]] std::optional<T> Last(const Topic<T>& topic) const {
    for (auto message = published.rbegin(); message != published.rend(); ++message) {
      if ((*message)->name == topic.name) {
        return TopicCodec<T>::Decode((*message)->value);
      }
    }
    return std::nullopt;
  }
  /// How often a topic was published.
  template <class T>
  [[nodiscard]] int Count(const Topic<T>& topic) const {
    return static_cast<int>(std::ranges::count(
        published, topic.name, [](const MessagePtr& message) { return message->name; }));
  }
  /// Delivers a value to an app at the link's current time.
  template <class T>
  void Send(App& app, const Topic<T>& topic, const T& value) const {
    SendStamped(app, topic, value, time);
  }
  /// As a sender of another clock does.
  template <class T>
  void SendStamped(App& app, const Topic<T>& topic, const T& value, Seconds stamp) const {
    app.Deliver(std::make_shared<const Message>(Message{.name = topic.name,
                                                        .value = TopicCodec<T>::Encode(value),
                                                        .time = stamp,
                                                        .source = "test",
                                                        .source_aux = "",
                                                        .community = ""}));
  }

  Seconds time{1767225600.0};
  Seconds clock_disagreement;
  bool replays = false;  ///< the app goes through its former life
  std::vector<MessagePtr> published;
  std::vector<std::string> subscriptions;
};

}  // namespace limpet
