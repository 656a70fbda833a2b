// SPDX-License-Identifier: MIT
// More connections, and more bytes, than there is room for: who is let in, and who has to go.
#include <memory>
#include <thread>
#include <vector>

#include "limpet/wire/little_endian.hpp"
#include "tests/support/loopback_broker.hpp"

namespace limpet {
namespace {

using namespace std::chrono_literals;

/// A broker with few seats and little memory, and crowds of peers.
class CrowdedBroker : public testing::Test {
 protected:
  static constexpr std::size_t kSeats = 8;
  static constexpr std::size_t kHeld = std::size_t{8} << 20;

  CrowdedBroker() : broker_(Options()) {}
  ~CrowdedBroker() override {
    broker_.Stop();
    if (serving_.joinable()) {
      serving_.join();
    }
  }
  CrowdedBroker(const CrowdedBroker&) = delete;
  CrowdedBroker& operator=(const CrowdedBroker&) = delete;

  static TcpBrokerOptions Options() {
    TcpBrokerOptions options;
    options.port = 0;
    options.warp = 20.0;  // DB_* ten times a second
    options.handshakes = kSeats;
    options.handshake_timeout = Seconds(60.0);
    options.broker.limits.held = kHeld;
    options.broker.limits.queue = 10 * kHeld;
    return options;
  }
  void Serve() {
    serving_ = std::thread([this] { broker_.Run(); });
  }
  const RawPeer& Connect(int room = 0) {
    peers_.push_back(std::make_unique<RawPeer>(broker_.port(), room));
    return *peers_.back();
  }
  std::unique_ptr<TcpClient> Join(const std::string& name, MailInbox* inbox = nullptr) {
    return std::make_unique<TcpClient>(TcpClientOptions{.port = broker_.port(),
                                                        .name = name,
                                                        .on_mail =
                                                            [inbox](const WireMessage& message) {
                                                              if (inbox != nullptr) {
                                                                inbox->Add(message);
                                                              }
                                                            },
                                                        .on_state = nullptr});
  }
  /// The figure of that name in DB_REFUSED, once it is at least one.
  static bool AwaitRefused(MailInbox& inbox, const std::string& name) {
    return inbox.AwaitThat([&name](const Message& message) {
      const auto* text = std::get_if<std::string>(&message.value);
      return message.name == "DB_REFUSED" && text != nullptr &&
             text->find(name + "=") != std::string::npos &&
             text->find(name + "=0") == std::string::npos;
    });
  }

  TcpBroker broker_;
  std::thread serving_;
  std::vector<std::unique_ptr<RawPeer>> peers_;
};

TEST_F(CrowdedBroker, HearsANewcomerThoughSilentOnesFillEverySeat) {
  Serve();
  for (std::size_t i = 0; i < 3 * kSeats; ++i) {
    Connect();
  }
  const RawPeer& newcomer = Connect();
  newcomer.Hello("pNewcomer");
  EXPECT_EQ(newcomer.Answer(), wire_type::kWelcome);
  EXPECT_TRUE(peers_.front()->IsClosed()) << "the oldest silent one had to go";
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("DB_REFUSED", Seconds(0.0));
  EXPECT_TRUE(AwaitRefused(inbox, "stranger"));
}

TEST_F(CrowdedBroker, LetsEveryoneInWhoHasSaidHello) {
  for (std::size_t i = 0; i < 3 * kSeats; ++i) {
    Connect().Hello("pEarly" + std::to_string(i));
  }
  Serve();  // as after a hang: all at once
  for (const auto& peer : peers_) {
    EXPECT_EQ(peer->Answer(), wire_type::kWelcome);
  }
}

/// The beginning of a packet of `size` bytes that claims to hold one message.
ByteBuffer Beginning(std::size_t size, std::size_t sent) {
  ByteBuffer bytes(sent);
  Put(Put(bytes.data(), static_cast<std::int32_t>(size)), std::int32_t{1});
  return bytes;
}

TEST_F(CrowdedBroker, BelievesNoLengthAndHasRoomForOthersBesideHalfPackets) {
  Serve();
  std::vector<std::thread> senders;
  for (int i = 0; i < 12; ++i) {
    const RawPeer& peer = Connect();
    peer.Hello("pHalf" + std::to_string(i));
    ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
    senders.emplace_back([&peer] {
      peer.Send(
          Beginning(std::size_t{64} << 20, std::size_t{3} << 20));  // until it is cut, or done
    });
  }
  MailInbox inbox, image;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("DB_REFUSED", Seconds(0.0));
  EXPECT_TRUE(AwaitRefused(inbox, "unfinished"));
  const auto viewer = Join("pViewer", &image);
  viewer->Subscribe("IMAGE", Seconds(0.0));
  const auto camera = Join("pCamera");
  camera->PublishValue("IMAGE", Binary(std::size_t{3} << 20));
  EXPECT_TRUE(image.Await("IMAGE").has_value());
  broker_.Stop();
  serving_.join();
  for (const auto& peer : peers_) {
    peer->HangUp();
  }
  for (std::thread& sender : senders) {
    sender.join();
  }
}

TEST_F(CrowdedBroker, KeepsMailForThoseWhoReadNothingWithinTheBudget) {
  Serve();
  for (int i = 0; i < 10; ++i) {
    const RawPeer& peer = Connect(4096);
    const std::string name = "pIdle" + std::to_string(i);
    peer.Hello(name);
    ASSERT_EQ(peer.Answer(), wire_type::kWelcome);
    peer.Send(
        PacketOf({.type = wire_type::kRegister, .source = name, .key = "FLOOD", .number = 0.0}));
  }
  MailInbox inbox;
  const auto reader = Join("pReader", &inbox);
  reader->Subscribe("DB_DROPPED", Seconds(0.0));
  const auto writer = Join("pWriter");
  const std::string text(4000, 'x');
  for (int i = 0; i < 2000; ++i) {  // 8 MB, 10 times: less than any one of them may have
    writer->Publish("FLOOD", std::string_view(text));
    while (writer->unsent() > 100'000) {
      std::this_thread::sleep_for(1ms);
    }
  }
  EXPECT_TRUE(inbox.AwaitThat([](const Message& message) {
    const auto* lost = std::get_if<std::string>(&message.value);
    return message.name == "DB_DROPPED" && lost != nullptr &&
           lost->find("pIdle") != std::string::npos;
  }));
  writer->Publish("AFTER", 1.0);
  reader->Subscribe("AFTER", Seconds(0.0));
  EXPECT_TRUE(inbox.Await("AFTER").has_value());
}

}  // namespace
}  // namespace limpet
