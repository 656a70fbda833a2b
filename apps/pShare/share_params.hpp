// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/sharing/share_lines.hpp"

namespace limpet {

/// pShare's block, with MOOS's names, and ours for sealed routes.
struct ShareParams {
  std::vector<std::string> outputs;
  std::vector<std::string> inputs;
  std::string key_file;
  bool allows_plain_routes = false;
  std::string to;
  Seconds max_age{5.0};
  std::string command_interface = "127.0.0.1";
  std::string sender;
  std::string multicast_address = MulticastPlan().group;
  int multicast_base_port = MulticastPlan().base_port;
  bool is_verbose = false;

  template <class V>
  void Describe(V& visit) {
    visit("output", outputs,
          "`src_name=X, dest_name=Y, route=host:port & multicast_8, frequency=, duration=, "
          "max_shares=, key=, to=, plain=`, or `X->Y:host:port`");
    visit("input", inputs,
          "`route=localhost:9200 & multicast_9, white_list=A&B*, interface=, key=, plain=`");
    visit("key_file", key_file,
          "Seals every route that names no key of its own; made by `limpet key new`");
    visit("allow_plain_routes", allows_plain_routes,
          "Routes without a key are MOOS's open datagrams: anybody can read and forge them");
    visit("to", to,
          "Community that sealed outputs are for, where their line names none: no other believes "
          "them");
    visit("max_age_s", max_age, "A sealed datagram that took longer is refused",
          InRange(Seconds(0.1), Seconds(3600.0)));
    visit("command_interface", command_interface,
          "Where plain inputs that PSHARE_CMD opens may listen: an IPv4 address of this machine; "
          "0.0.0.0: all");
    visit("sender", sender,
          "Name that senders know this app by, in their `to`; empty: <community>/<app>");
    visit("multicast_address", multicast_address, "Group of every multicast_N");
    visit("multicast_base_port", multicast_base_port, "Port of multicast_0",
          InRange(1, 65535 - kMulticastChannels + 1));
    visit("verbose", is_verbose, "Accepted; PSHARE_COUNTS tells what goes on");
  }

  [[nodiscard]] MulticastPlan Multicast() const { return {multicast_address, multicast_base_port}; }
  [[nodiscard]] ShareSecurity Security() const {
    return {.key_file = key_file, .is_plain = allows_plain_routes};
  }
};

}  // namespace limpet
