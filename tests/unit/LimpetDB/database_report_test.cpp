// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/database_report.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

const Seconds kStart(1000.0);

/// A broker and what it says of itself.
struct Database {
  /// What LIMPETDB_WARNINGS is written as at that time; nothing: not written.
  std::optional<std::string> SaidAt(double elapsed) {
    const auto words = report.Take(broker, kStart + Seconds(elapsed), UnixTime());
    const auto said =
        std::ranges::find(words, "LIMPETDB_WARNINGS", [](const auto& word) { return word.first; });
    return said == words.end() ? std::nullopt : std::optional(std::string(said->second));
  }
  Broker broker{{.community = "alpha", .hostname = "here", .limits = {.queue = 1000}}, kStart};
  DatabaseReport report{"alpha", 1.0, "here", kStart};
};

bool Says(const std::optional<std::string>& words, const std::string& id) {
  return words && words->find(id + " (") != std::string::npos;
}

TEST(DatabaseReport, WarnsWhileClientsAreCutOrRefusedAndForHalfAMinute) {
  for (const auto& [count, id] : {std::pair{&BrokerCounts::strangers, "STRANGERS"},
                                  std::pair{&BrokerCounts::unfinished, "UNFINISHED"},
                                  std::pair{&BrokerCounts::stalled, "STALLED"},
                                  std::pair{&BrokerCounts::no_room, "NO_ROOM"}}) {
    Database database;
    ++(database.broker.counts().*count);
    EXPECT_TRUE(Says(database.SaidAt(0.0), id)) << id;
    EXPECT_FALSE(database.SaidAt(30.0)) << id;
    EXPECT_EQ(database.SaidAt(30.5), "none") << id;
  }
}

TEST(DatabaseReport, WarnsOfAClientThatLosesMailUntilItLosesNoMore) {
  Database database;
  const auto client =
      database.broker
          .Admit({.type = wire_type::kHello, .key = "asynchronous", .text = "pSlow"}, kStart)
          .client;
  const auto send = [&](const WireMessage& message) {
    EXPECT_FALSE(database.broker.Receive(*client, PacketOf(message), kStart));
  };
  send({.type = wire_type::kRegister, .source = "pSlow", .key = "X", .number = 0.0});
  for (int i = 0; i < 20; ++i) {
    send({.type = wire_type::kNotify,
          .data_type = wire_data::kString,
          .source = "pSlow",
          .key = "X",
          .text =
              "a hundred bytes of text, and the client never takes any of what it has asked for: "
              "so it waits"});
  }
  EXPECT_TRUE(Says(database.SaidAt(0.0), "SLOW_pSlow"));
  EXPECT_EQ(database.SaidAt(30.5), "none");
}

TEST(DatabaseReport, TheCountInAStandingWarningGrowsWithoutAFlood) {
  Database database;
  int words = 0;
  std::string last;
  for (int tick = 0; tick <= 40; ++tick) {
    ++database.broker.counts().no_room;
    if (const auto said = database.SaidAt(0.25 * tick)) {
      ++words;
      last = *said;
    }
  }
  EXPECT_EQ(words, 6);
  EXPECT_EQ(last.substr(0, last.find(" writes")), "NO_ROOM (alarm): 41");
}

}  // namespace
}  // namespace limpet
