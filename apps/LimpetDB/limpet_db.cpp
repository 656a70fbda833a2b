// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/limpet_db.hpp"

#include <cstdlib>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include "apps/LimpetDB/database_report.hpp"
#include "limpet/app/app_command.hpp"
#include "limpet/app/heartbeat.hpp"
#include "limpet/app/host_faults.hpp"
#include "limpet/app/run_app.hpp"
#include "limpet/core/byte_units.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/host_name.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

std::string AddressOf(const std::string& listen_on) {
  if (listen_on == "loopback") {
    return "127.0.0.1";
  }
  return listen_on == "all" ? "0.0.0.0" : listen_on;
}

std::size_t BytesOf(double mib) { return static_cast<std::size_t>(mib * kBytesPerMib); }

/// The file that a launcher holds open for this process and its successors; -1 if there is none.
int KeptDescriptor() {
  const char* text = std::getenv("LIMPET_KEPT_FD");  // NOLINT(concurrency-mt-unsafe): one thread
  const auto number = ParseNumber(text != nullptr ? text : "");
  const int descriptor = number && *number > STDERR_FILENO ? static_cast<int>(*number) : -1;
  return descriptor >= 0 && ::fcntl(descriptor, F_GETFD) >= 0 ? descriptor : -1;
}

DatabaseParams ParamsOf(const MissionFile& mission) {
  // A mission written for MOOSDB says ClientTimeout there.
  for (const char* name : {"LimpetDB", "MOOSDB"}) {
    if (const ConfigBlock* block = mission.Block(name)) {
      std::vector<std::string> known{"ClientTimeout", "AppTick", "CommsTick"};
      return ReadParams<DatabaseParams>(*block, known);
    }
  }
  return {};
}

TcpBrokerOptions OptionsOf(const AppCommand& command) {
  const DatabaseParams params = ParamsOf(command.mission);
  TcpBrokerOptions options;
  options.broker.community = command.community;
  options.broker.hostname = HostName().value_or("localhost");
  options.broker.limits.clients = static_cast<std::size_t>(params.max_clients);
  options.broker.limits.variables = static_cast<std::size_t>(params.max_variables);
  options.broker.limits.queue = BytesOf(params.queue_mib);
  options.broker.limits.stored = BytesOf(params.stored_mib);
  options.broker.limits.held = BytesOf(params.held_mib);
  options.bind_address = AddressOf(params.listen_on);
  options.port = command.port;
  options.warp = command.warp;
  options.client_timeout = params.client_timeout;
  options.kept = BytesOf(params.kept_mib);
  options.kept_descriptor = options.kept > 0 ? KeptDescriptor() : -1;
  return options;
}

/// Freed memory stays mapped for the next large message: ten images a second would else
/// find cold pages each time, which cost more than all else about it. TcpBroker gives it back when
/// a burst is over.
void KeepMemoryWarm() {
  constexpr int kWarm = 16 << 20;
  mallopt(M_MMAP_THRESHOLD, kWarm);  // NOLINT(concurrency-mt-unsafe): before any other thread
  mallopt(M_TRIM_THRESHOLD, kWarm);  // NOLINT(concurrency-mt-unsafe): as above
}

/// A connection is a file; systems start programs with 1024 where many more are allowed.
void AllowManyConnections() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) == 0) {
    files.rlim_cur = files.rlim_max;
    static_cast<void>(::setrlimit(RLIMIT_NOFILE, &files));  // fewer connections, if not
  }
}

int Serve(const AppCommand& command) {
  Heartbeat heart;
  const HostFaults host;
  heart.Beat();
  KeepMemoryWarm();
  AllowManyConnections();
  TcpBrokerOptions options = OptionsOf(command);
  DatabaseReport report(command.community, command.warp,
                        fmt::format("{}:{}", options.bind_address, command.port),
                        MoosTime(command.warp));
  options.broker.watched = "APPCAST_REQ";
  options.broker.on_watched = [&](std::string_view text) {
    report.OnRequest(text, MoosTime(command.warp));
  };
  options.report = [&](const Broker& broker, Seconds now) {
    heart.Beat();  // the thread that serves lives
    return report.Take(broker, now, UnixTime() + host.wall_ahead());
  };
  TcpBroker broker(options);
  CatchEndSignals();
  std::thread watch([&broker] {
    while (!EndIsRequested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    broker.Stop();
  });
  fmt::print(stderr, "LimpetDB: community {} on {}:{}, time warp {:g}\n", command.community,
             options.bind_address, broker.port(), command.warp);
  broker.Run();
  heart.Pause();
  watch.join();
  return 0;
}

}  // namespace

int RunDatabase(int argc, const char* const* argv) {
  try {
    const AppCommand command =
        ReadAppCommand("LimpetDB", {argv + 1, static_cast<std::size_t>(argc - 1)});
    if (command.wants_help) {
      fmt::print("{}", AppCommandHelp("LimpetDB"));
      return 0;
    }
    return Serve(command);
  } catch (const ConfigError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "LimpetDB: {}\n", error.what());
    return 1;
  }
}

}  // namespace limpet
