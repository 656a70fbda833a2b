// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/params.hpp"
#include "limpet/pubsub/tcp_broker.hpp"

namespace limpet {

/// The database's block in a mission file.
struct DatabaseParams {
  std::string listen_on = "loopback";
  Seconds client_timeout{5.0};
  double queue_mib = 4.0;
  double stored_mib = 256.0;
  double held_mib = 88.0;
  double kept_mib = 8.0;
  int max_clients = 1000;
  int max_variables = 100'000;

  template <class V>
  void Describe(V& visit) {
    visit("listen_on", listen_on,
          "loopback; all: every interface, with neither password nor encryption; or one address");
    visit("client_timeout_s", client_timeout, "silence after which a client is dropped",
          InRange(Seconds(1.0), Seconds(3600.0)));
    visit("queue_mib", queue_mib, "memory for unsent mail of one client [MiB]",
          InRange(0.1, 1024.0));
    visit("stored_mib", stored_mib, "latest values of all variables together [MiB]",
          InRange(1.0, 65536.0));
    visit("held_mib", held_mib,
          "packets that have not arrived whole and unsent mail, of all clients together [MiB]",
          InRange(8.0, 65536.0));
    visit("kept_mib", kept_mib, "latest values kept for a restart by pLaunch; 0: none [MiB]",
          InRange(0.0, 1024.0));
    visit("max_clients", max_clients, "clients at a time", InRange(1, 10'000));
    visit("max_variables", max_variables, "variables in all", InRange(10, 10'000'000));
  }
};

/// Runs the database until SIGINT or SIGTERM. Exit codes: 0 ended in order, 1 cannot listen,
/// 2 command line or configuration.
[[nodiscard]] int RunDatabase(int argc, const char* const* argv);

}  // namespace limpet
