// SPDX-License-Identifier: MIT
// Lesson 1: a value goes from one program to another through a community's database.
#include <cstdint>
#include <future>
#include <string>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "limpet/pubsub/tcp_broker.hpp"
#include "limpet/pubsub/tcp_client.hpp"

namespace limpet {
namespace {

/// What a program in another process does: it joins, and is called for each piece of mail.
double ReadOne(std::uint16_t port, std::string_view variable) {
  std::promise<double> first;
  TcpClientOptions options;
  options.port = port;
  options.name = "pReader";
  options.on_mail = [&first, is_first = true](const WireMessage& mail) mutable {
    if (is_first) first.set_value(mail.number);
    is_first = false;
  };
  TcpClient reader(options);
  reader.Subscribe(std::string(variable), Seconds(0.0));  // 0: every write
  return first.get_future().get();
}

int Run() {
  TcpBrokerOptions options;
  options.port = 0;  // any free one; a mission's LimpetDB takes ServerPort
  TcpBroker broker(options);
  std::thread serving([&broker] { broker.Run(); });

  TcpClientOptions sensor;
  sensor.port = broker.port();
  sensor.name = "iThermometer";
  TcpClient writer(sensor);
  writer.Publish("WATER_TEMPERATURE", 11.5);

  fmt::print("pReader read {} degrees\n", ReadOne(broker.port(), "WATER_TEMPERATURE"));
  broker.Stop();
  serving.join();
  return 0;
}

}  // namespace
}  // namespace limpet

int main() { return limpet::Run(); }
