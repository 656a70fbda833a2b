// SPDX-License-Identifier: MIT
// A LimpetDB that is killed, with its launcher and its clients, as processes and sockets.
#include <csignal>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/launch/supervisor.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/mail_inbox.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

class DatabaseRestart : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "LimpetDB";
    ASSERT_TRUE(fs::exists(program)) << program;
    supervisor_.Start(
        {.name = "LimpetDB",
         .program = "/bin/sh",
         .args = {"-c", "echo $$ > " + PidFile().string() + "; exec " + program.string() +
                            " --moos_port=" + std::to_string(port_)},
         .is_database = true});
  }
  [[nodiscard]] fs::path PidFile() const { return folder_.path() / "pid"; }

  std::unique_ptr<TcpClient> Join(const std::string& name, MailInbox& inbox) const {
    auto client = std::make_unique<TcpClient>(
        TcpClientOptions{.port = port_,
                         .name = name,
                         .on_mail = [&inbox](const WireMessage& message) { inbox.Add(message); },
                         .on_state = nullptr});
    client->Subscribe("DEPLOY", Seconds(0.0));
    return client;
  }
  void Kill() const {
    pid_t pid = 0;
    std::ifstream(PidFile()) >> pid;
    ASSERT_GT(pid, 0);
    ASSERT_EQ(::kill(pid, SIGKILL), 0);
  }
  /// Minds the processes until the client is (not) connected; how long that took.
  Seconds Until(const TcpClient& client, bool is_connected) {
    const Seconds begin = SteadyTime();
    while ((client.state() == TcpClient::State::kConnected) != is_connected &&
           SteadyTime() - begin < Seconds(60.0)) {
      EXPECT_TRUE(supervisor_.Poll());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(client.state() == TcpClient::State::kConnected, is_connected);
    return SteadyTime() - begin;
  }

  TemporaryFolder folder_;
  std::uint16_t port_ = FreePort();
  Supervisor supervisor_{folder_.path(), {}, [](const std::string&) {}};
};

TEST_F(DatabaseRestart, LosesNothingThatWasPoked) {
  MailInbox before, after;
  const auto operators = Join("uPoke", before);
  operators->Publish("DEPLOY", "true");
  ASSERT_TRUE(before.Await("DEPLOY").has_value());
  Kill();
  Until(*operators, false);
  const Seconds back = Until(*operators, true);
  RecordProperty("back_after_ms", static_cast<int>(1e3 * back.value()));
  const auto late = Join("pHelm", after);
  EXPECT_TRUE(after.Await("DEPLOY").has_value());
}

}  // namespace
}  // namespace limpet
