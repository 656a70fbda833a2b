// SPDX-License-Identifier: MIT
// Each recorded client, byte for byte and in the recorded order, against our broker: what it hears
// must be what the stock broker told it, times aside.
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limpet/pubsub/broker.hpp"
#include "tests/support/moos_captures.hpp"
#include "tests/support/outgoing_bytes.hpp"

namespace limpet {
namespace {

/// One message without what differs from run to run.
std::string Essence(const WireMessage& m) {
  if (m.type == wire_type::kPoison) {
    return "poison";
  }
  const bool is_clock =
      m.type == wire_type::kWelcome || m.type == wire_type::kTiming || m.type == wire_type::kNull;
  const bool is_relative = m.id == -2;
  return fmt::format("{} {} {} {} {} {} {} {} {}", m.type, m.data_type, m.id, m.source,
                     m.source_aux.starts_with("hostname=") ? "" : m.source_aux, m.community, m.key,
                     is_clock || (is_relative && m.key.starts_with("DB_")) ? 0.0 : m.number,
                     m.text);
}

/// The broker's own variables come by its own timer; answers about them differ in times.
bool IsOwn(const WireMessage& m) {
  return m.key.starts_with("DB_") || m.key == "PROC_SUMMARY" || m.key == "VAR_SUMMARY";
}

std::vector<std::string> EssenceOf(ByteView bytes) {
  std::vector<std::string> list;
  while (bytes.size() >= kPacketHeaderSize) {
    const std::size_t size = DecodePacketHeader(bytes)->size;
    PacketReader reader(bytes.first(size));
    while (!reader.is_at_end()) {
      const auto message = reader.Next();
      if (message && !IsOwn(*message)) {
        list.push_back(Essence(*message));
      }
    }
    bytes = bytes.subspan(size);
  }
  return list;
}

/// Clients fed from their recordings; what the broker sends to each is kept.
class Replay {
 public:
  explicit Replay(const std::string& community)
      : broker_({.community = community, .hostname = "vm", .limits = {}}, Seconds(1e9)) {}

  void Feed(const Segment& segment, Seconds now) {
    Peer& peer = peers_[segment.session];
    if (peer.incoming.empty() && peer.fed == 0) {
      peer.incoming = BytesOfFile(Capture(segment.session + ".client.bin"));
    }
    if (segment.is_end) {
      if (peer.client) {
        broker_.Leave(*peer.client, now);
        peer.client.reset();
      }
      return;
    }
    peer.fed += segment.size;
    WorkOff(peer, now);
    Collect(now);
  }
  [[nodiscard]] const ByteBuffer& HeardBy(const std::string& session) {
    return peers_[session].heard;
  }

 private:
  struct Peer {
    ByteBuffer incoming;
    std::size_t fed = 0, used = 0;
    std::optional<Broker::Client> client;
    bool is_known = false;
    ByteBuffer heard;
  };

  void WorkOff(Peer& peer, Seconds now) {
    if (peer.used == 0 && peer.fed >= kGreeting.size()) {
      peer.used = kGreeting.size();
    }
    while (peer.used >= kGreeting.size() && peer.fed - peer.used >= kPacketHeaderSize) {
      const ByteView rest = ByteView(peer.incoming).subspan(peer.used, peer.fed - peer.used);
      const std::size_t size = DecodePacketHeader(rest)->size;
      if (size > rest.size()) {
        return;
      }
      peer.used += size;
      if (!peer.is_known) {
        peer.is_known = true;
        auto admission = broker_.Admit(*PacketReader(rest.first(size)).Next(), now);
        peer.client = admission.client;
        peer.heard.insert(peer.heard.end(), admission.answer.begin(), admission.answer.end());
      } else if (peer.client) {
        EXPECT_FALSE(broker_.Receive(*peer.client, rest.first(size), now).has_value());
      }
    }
  }

  void Collect(Seconds now) {
    for (const Broker::Client client : broker_.TakeReady()) {
      OutgoingPacket packet;
      while (broker_.TakePacket(client, packet, now)) {
        for (auto& [name, peer] : peers_) {
          if (peer.client == client) {
            const ByteBuffer bytes = BytesOf(packet);
            peer.heard.insert(peer.heard.end(), bytes.begin(), bytes.end());
          }
        }
      }
    }
  }

  Broker broker_;
  std::map<std::string, Peer> peers_;
};

class CaptureReplay : public testing::TestWithParam<std::string> {};

TEST_P(CaptureReplay, HearsWhatTheStockBrokerTold) {
  const auto log = Capture(GetParam() + ".txt");
  if (!std::filesystem::exists(log)) {
    GTEST_SKIP() << "this recording is not part of the project, and not beside it";
  }
  const double warp = GetParam() == "timewarp5" ? 5.0 : 1.0;
  auto replay = std::make_unique<Replay>("shoreside");
  std::set<std::string> present;
  const auto compare = [&replay](const std::string& session) {
    const ByteBuffer told = BytesOfFile(Capture(session + ".server.bin"));
    EXPECT_EQ(EssenceOf(replay->HeardBy(session)), EssenceOf(told)) << session;
  };
  for (const Segment& segment : SegmentsOf(log)) {
    if (segment.is_from_client && !segment.is_end) {
      replay->Feed(segment, Seconds(warp * (1e9 + segment.t)));
      present.insert(segment.session);
    } else if (segment.is_from_client && present.erase(segment.session) > 0) {
      replay->Feed(segment, Seconds(warp * (1e9 + segment.t)));
      compare(segment.session);
    } else if (segment.is_end && present.contains(segment.session)) {
      // The broker hung up first: it died, and another one takes its place.
      compare(segment.session);
      present.clear();
      replay = std::make_unique<Replay>("shoreside");
    }
  }
  for (const std::string& session : present) {
    compare(session);
  }
}

// Scenarios whose every client was recorded.
INSTANTIATE_TEST_SUITE_P(Scenarios, CaptureReplay,
                         testing::Values("handshake-async", "handshake-sync", "uPoke-double",
                                         "uPoke-string", "uPoke-binary", "uPoke-sync",
                                         "large-binary", "type-mismatch", "unregister", "latched",
                                         "wildcard", "duplicate-name", "mute-timeout",
                                         "requests-async", "requests-sync", "db-vars",
                                         "kill-disconnect", "reconnect", "timewarp5", "umm-app"),
                         [](const auto& scenario) {
                           std::string name = scenario.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace limpet
