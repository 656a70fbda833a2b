// SPDX-License-Identifier: MIT
#include "limpet/pubsub/tcp_client.hpp"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "limpet/pubsub/tcp_broker.hpp"
#include "tests/support/mail_inbox.hpp"

namespace limpet {
namespace {

using namespace std::chrono_literals;

/// True once the client has noticed that its connection is gone. What is written before it does
/// is lost with the connection, as with any stream.
bool AwaitLoss(const TcpClient& client) {
  for (int tries = 0; tries < 500 && client.state() == TcpClient::State::kConnected; ++tries) {
    std::this_thread::sleep_for(10ms);
  }
  return client.state() != TcpClient::State::kConnected;
}

TEST(TcpClient, ConnectsAgainAndRegistersAnewWhenTheBrokerComesBack) {
  TcpBrokerOptions options;
  options.port = 0;
  auto broker = std::make_unique<TcpBroker>(options);
  options.port = broker->port();
  std::thread thread([&broker] { broker->Run(); });
  MailInbox inbox;
  TcpClient reader({.port = options.port,
                    .name = "pReader",
                    .on_mail = [&inbox](const WireMessage& message) { inbox.Add(message); },
                    .on_state = nullptr});
  reader.Subscribe("BEFORE", Seconds(0.0));
  reader.Subscribe("AFTER", Seconds(0.0));
  TcpClient writer(
      {.port = options.port, .name = "pWriter", .on_mail = nullptr, .on_state = nullptr});
  writer.Publish("BEFORE", 1.0);
  EXPECT_TRUE(inbox.Await("BEFORE").has_value());
  broker->Stop();
  thread.join();
  broker.reset();
  EXPECT_TRUE(AwaitLoss(writer));
  writer.Publish("AFTER", 2.0);
  broker = std::make_unique<TcpBroker>(options);
  thread = std::thread([&broker] { broker->Run(); });
  EXPECT_TRUE(inbox.Await("AFTER").has_value());
  broker->Stop();
  thread.join();
}

TEST(TcpClient, ComesBackWhenItsOwnThreadWasBusyWhileTheBrokerWent) {
  TcpBrokerOptions options;
  options.port = 0;
  auto broker = std::make_unique<TcpBroker>(options);
  options.port = broker->port();
  std::thread thread([&broker] { broker->Run(); });
  std::atomic<bool> is_busy{false}, may_go_on{false};
  MailInbox inbox;
  TcpClient reader({.port = options.port,
                    .name = "pReader",
                    .on_mail =
                        [&](const WireMessage& message) {
                          if (message.key == "HOLD") {
                            is_busy = true;
                            is_busy.notify_all();
                            may_go_on.wait(false);
                          }
                          inbox.Add(message);
                        },
                    .on_state = nullptr});
  reader.Subscribe("HOLD", Seconds(0.0));
  reader.Subscribe("AFTER", Seconds(0.0));
  TcpClient writer(
      {.port = options.port, .name = "pWriter", .on_mail = nullptr, .on_state = nullptr});
  writer.Publish("HOLD", 1.0);
  is_busy.wait(false);
  broker->Stop();
  thread.join();
  broker.reset();
  // Longer than a client is quiet: its keep-alive and the end of its connection are due at once.
  std::this_thread::sleep_for(500ms);
  may_go_on = true;
  may_go_on.notify_all();
  EXPECT_TRUE(AwaitLoss(writer));
  broker = std::make_unique<TcpBroker>(options);
  thread = std::thread([&broker] { broker->Run(); });
  writer.Publish("AFTER", 2.0);
  EXPECT_TRUE(inbox.Await("AFTER").has_value());
  broker->Stop();
  thread.join();
}

}  // namespace
}  // namespace limpet
