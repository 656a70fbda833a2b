// SPDX-License-Identifier: MIT
// The tools against a broker on a real socket.
#include "limpet/console/tools.hpp"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "limpet/console/community.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/pubsub/tcp_broker.hpp"
#include "tests/support/pseudo_terminal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ToolsTest : public ::testing::Test {
 protected:
  ToolsTest() {
    TcpBrokerOptions options;
    options.broker.community = "alpha";
    options.port = 0;
    options.warp = 5.0;
    broker_ = std::make_unique<TcpBroker>(options);
    thread_ = std::thread([this] { broker_->Run(); });
    port_ = fmt::format("--port={}", broker_->port());
  }
  ~ToolsTest() override {
    broker_->Stop();
    thread_.join();
  }
  ToolsTest(const ToolsTest&) = delete;
  ToolsTest& operator=(const ToolsTest&) = delete;

  int Run(Tool tool, std::vector<std::string> words) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int code = tool("limpet tool", words);
    out_ = ::testing::internal::GetCapturedStdout();
    err_ = ::testing::internal::GetCapturedStderr();
    return code;
  }
  [[nodiscard]] CommunityAddress Address() const {
    CommunityAddress address;
    address.port = broker_->port();
    return address;
  }

  std::unique_ptr<TcpBroker> broker_;
  std::thread thread_;
  std::string port_;
  std::string out_, err_;
  TemporaryFolder folder_;
};

TEST_F(ToolsTest, LearnTheWarpFromTheBroker) {
  Community community(Address(), "uTest");
  EXPECT_EQ(community.client().warp(), 5.0);
  EXPECT_NEAR(community.Now().value(), MoosTime(5.0).value(), 5.0);
  EXPECT_EQ(community.client().community(), "alpha");
}

TEST_F(ToolsTest, PokeShowsWhatWasAndWhatIs) {
  EXPECT_EQ(Run(RunPoke, {port_, "SPEED=1.5", "--name=one"}), 0) << err_;
  EXPECT_EQ(Run(RunPoke, {port_, "SPEED=2", "LABEL:=007"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("SPEED     D 1.5   one         "));
  EXPECT_THAT(out_, HasSubstr("D 2\n"));
  EXPECT_THAT(out_, HasSubstr("S 007\n"));
}

TEST_F(ToolsTest, PokeFailsLoudlyWhenTheTypeIsLocked) {
  EXPECT_EQ(Run(RunPoke, {port_, "MODE=on"}), 0);
  EXPECT_EQ(Run(RunPoke, {port_, "MODE=3", "OTHER=1"}), 1);
  EXPECT_THAT(out_, HasSubstr("refused"));
  EXPECT_THAT(out_, HasSubstr("D 1\n")) << "the others are written";
  EXPECT_THAT(err_, HasSubstr("limpet tool: MODE was refused: it holds a string"));
}

TEST_F(ToolsTest, PokeTakesMoosSpellings) {
  EXPECT_EQ(
      Run(RunPoke, {fmt::format("server_port={}", broker_->port()), "host=localhost", "-q", "A=1"}),
      0)
      << err_;
  EXPECT_EQ(out_, "");
}

TEST_F(ToolsTest, PokeNamesABadWord) {
  EXPECT_EQ(Run(RunPoke, {port_, "A B=1"}), 2);
  EXPECT_EQ(Run(RunPoke, {port_, "nothing"}), 2);
  EXPECT_EQ(Run(RunPoke, {port_}), 2);
}

TEST_F(ToolsTest, ScopePrintsATableOnce) {
  EXPECT_EQ(Run(RunPoke, {port_, "SPEED=1.5", "EVIL=a\033[2Jb", "--name=uP"}), 0);
  EXPECT_EQ(Run(RunScope, {port_, "--once", "S*", "EVIL"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("VARIABLE  SOURCE     AGE      Hz  T VALUE\n"));
  EXPECT_THAT(out_, HasSubstr("D 1.5\n"));
  EXPECT_THAT(out_, HasSubstr("S a\\x1b[2Jb\n"));
  EXPECT_THAT(out_, AllOf(Not(HasSubstr("DB_")), Not(HasSubstr("\033"))));
}

TEST_F(ToolsTest, ScopeCreatesNoVariableByLooking) {
  EXPECT_EQ(Run(RunScope, {port_, "--once", "TYPO"}), 1);
  EXPECT_EQ(Run(RunScope, {port_, "--once"}), 0);
  EXPECT_THAT(out_, Not(HasSubstr("TYPO")));
}

TEST_F(ToolsTest, ScopeChoosesBySource) {
  EXPECT_EQ(Run(RunPoke, {port_, "A=1", "--name=pA"}), 0);
  EXPECT_EQ(Run(RunPoke, {port_, "B=1", "--name=pB"}), 0);
  EXPECT_EQ(Run(RunScope, {port_, "--once", "--source", "pB"}), 0);
  EXPECT_THAT(out_, AllOf(HasSubstr("\nB "), Not(HasSubstr("\nA "))));
}

TEST_F(ToolsTest, PlayBringsALogIntoTheCommunityAtAnySpeed) {
  const auto log = folder_.path() / "run.alog";
  std::ofstream(log) << "%% LOGSTART 5 \n"
                        "0.0 NAV_X pNav 1.0 \n"
                        "1.0 MODE pHelm:aux ACTIVE \n"
                        "2.0 NAV_X pNav 2.0 \n";
  const Seconds start = SteadyTime();
  EXPECT_EQ(Run(RunPlay, {log.string(), port_, "--speed", "4"}), 0) << err_;
  // Two seconds of log, four times as fast, on a clock of warp 5.
  EXPECT_GE((SteadyTime() - start).value(), 0.1);
  EXPECT_THAT(out_, HasSubstr("played 3 messages, 2.0 s of log in "));
  EXPECT_EQ(Run(RunScope, {port_, "--once", "NAV_X", "MODE"}), 0);
  EXPECT_THAT(out_, HasSubstr("D 2\n"));
  EXPECT_THAT(out_, HasSubstr("pHelm:aux"));
}

TEST_F(ToolsTest, PlayDeliversEveryMessageInOrderAtFullSpeed) {
  constexpr int kCount = 20'000;
  const auto log = folder_.path() / "run.alog";
  {
    std::ofstream out(log);
    for (int i = 0; i < kCount; ++i) {
      out << fmt::format("{:.2f} COUNT p {} \n", 0.01 * i, i);
    }
  }
  Community reader(Address(), "uReader");
  reader.Watch("COUNT");
  ASSERT_TRUE(reader.Settle().has_value());
  EXPECT_EQ(Run(RunPlay, {log.string(), port_, "--speed=max", "--as", "me"}), 0) << err_;
  const auto mail = reader.Settle();
  ASSERT_TRUE(mail.has_value());
  int expected = 0;
  for (const Mail& piece : *mail) {
    if (piece.message.name == "COUNT") {
      EXPECT_EQ(std::get<double>(piece.message.value), expected++);
      EXPECT_EQ(piece.message.source, "me");
      EXPECT_EQ(piece.message.source_aux, "p");
    }
  }
  EXPECT_EQ(expected, kCount);
}

TEST_F(ToolsTest, PlayFailsWithoutALogOrAnythingInIt) {
  EXPECT_EQ(Run(RunPlay, {(folder_.path() / "none.alog").string(), port_}), 1);
  EXPECT_EQ(Run(RunPlay, {port_}), 2);
  EXPECT_EQ(Run(RunPlay, {"a.alog", port_, "--speed", "0"}), 2);
}

/// Broker and tool in one child process: this one must not fork with threads of its own.
int RunScopeBesideABroker(std::vector<std::string> words) {
  TcpBrokerOptions options;
  options.broker.community = "alpha";
  options.port = 0;
  TcpBroker broker(options);
  std::thread thread([&broker] { broker.Run(); });
  words.push_back(fmt::format("--port={}", broker.port()));
  const int code = RunScope("uScope", words);
  broker.Stop();
  thread.join();
  return code;
}

TEST(ScopeTool, IsALiveTableOnATerminalUntilQ) {
  PseudoTerminal pty;
  pty.Type("q");
  const auto [status, output] = pty.Run([] {
    ::setenv("TERM", "xterm", 1);  // NOLINT(concurrency-mt-unsafe): alone in its process
    return RunScopeBesideABroker({"A*"});
  });
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_THAT(output, HasSubstr("alpha at localhost:"));
  EXPECT_THAT(output, HasSubstr("0 of 0 variables"));
  EXPECT_THAT(output, ::testing::EndsWith("\033[?1049l"));
  EXPECT_TRUE(pty.IsAsBefore());
}

TEST(ScopeTool, EndsOnASignalAndLeavesTheTerminalAsItWas) {
  PseudoTerminal pty;
  const auto [status, output] = pty.Run([&pty] {
    ::setenv("TERM", "xterm", 1);  // NOLINT(concurrency-mt-unsafe): alone in its process
    std::thread killer([&pty] {
      if (pty.Await("variables")) {
        ::kill(::getpid(), SIGTERM);
      }
    });
    const int code = RunScopeBesideABroker({});
    killer.join();
    return code;
  });
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(pty.IsAsBefore());
}

class StatusToolTest : public ToolsTest {
 protected:
  StatusToolTest() {
    std::ofstream(mission_) << "ServerHost = localhost\n"
                            << "ServerPort = " << broker_->port() << "\n"
                            << "ProcessConfig = ANTLER\n{\n  Run = LimpetDB\n  Run = pNav\n"
                            << "  Run = pHelm\n}\n";
  }
  std::filesystem::path mission_ = folder_.path() / "mission.moos";
};

TEST_F(StatusToolTest, NamesWhoIsMissing) {
  const Community present(Address(), "pNav");
  EXPECT_EQ(Run(RunStatus, {mission_.string()}), 1);
  EXPECT_THAT(out_, HasSubstr("pNav     up "));
  EXPECT_THAT(out_, HasSubstr("pHelm    AWOL "));
  EXPECT_THAT(out_, HasSubstr("1 missing: pHelm\n"));
  EXPECT_THAT(out_, Not(HasSubstr("uStatus")));
}

TEST_F(StatusToolTest, IsContentWhenAllAreThereAndTakesAFolder) {
  const Community nav(Address(), "pNav");
  const Community helm(Address(), "pHelm");
  EXPECT_EQ(Run(RunStatus, {folder_.path().string()}), 0);
  EXPECT_THAT(out_, HasSubstr("all present\n"));
  EXPECT_THAT(out_, HasSubstr("alpha at localhost:"));
  EXPECT_THAT(out_, HasSubstr("warp 5"));
}

TEST_F(StatusToolTest, WaitsForTheMissingIfAsked) {
  const Community nav(Address(), "pNav");
  std::unique_ptr<Community> helm;
  std::thread late([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    helm = std::make_unique<Community>(Address(), "pHelm");
  });
  EXPECT_EQ(Run(RunStatus, {mission_.string(), "--wait", "5"}), 0) << out_;
  late.join();
}

/// A port that somebody holds and nobody serves.
class DeafPort {
 public:
  explicit DeafPort(bool listens) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&place), size), 0);
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&place), &size), 0);
    port_ = fmt::format("--port={}", ntohs(place.sin_port));
    if (listens) {
      EXPECT_EQ(::listen(socket_, 5), 0);
    }
  }
  ~DeafPort() { ::close(socket_); }
  DeafPort(const DeafPort&) = delete;
  DeafPort& operator=(const DeafPort&) = delete;
  [[nodiscard]] const std::string& option() const { return port_; }

 private:
  int socket_;
  std::string port_;
};

TEST_F(ToolsTest, SayWhereNobodyAnswersAndWhatToDo) {
  const DeafPort nobody(false);
  const auto log = folder_.path() / "run.alog";
  std::ofstream(log) << "0.0 A p 1 \n";
  EXPECT_EQ(Run(RunScope, {nobody.option()}), 2);
  EXPECT_THAT(err_, HasSubstr("limpet tool: no community at localhost:" +
                              nobody.option().substr(7) + " (Connection refused)"));
  EXPECT_THAT(err_, HasSubstr("limpet launch"));
  EXPECT_EQ(Run(RunPoke, {nobody.option(), "A=1"}), 2);
  EXPECT_EQ(Run(RunPlay, {nobody.option(), log.string()}), 2);
  EXPECT_EQ(Run(RunStatus, {nobody.option()}), 2);
}

TEST_F(ToolsTest, DoNotHangOnAPortThatSaysNothing) {
  const DeafPort deaf(true);
  EXPECT_EQ(Run(RunStatus, {deaf.option(), "--timeout", "0.2"}), 2);
  EXPECT_THAT(err_, HasSubstr("does not answer as a MOOS database does"));
}

TEST_F(ToolsTest, SayWhyTheyWereRefused) {
  const Community first(Address(), "same");
  EXPECT_EQ(Run(RunPoke, {port_, "A=1", "--name", "same"}), 2);
  EXPECT_THAT(err_, HasSubstr("the name same is in use"));
}

TEST_F(ToolsTest, HelpEvenWithoutACommunity) {
  for (const Tool tool : {RunScope, RunPoke, RunPlay, RunStatus}) {
    EXPECT_EQ(Run(tool, {"--help"}), 0);
    EXPECT_THAT(out_, HasSubstr("usage: limpet tool"));
    EXPECT_THAT(out_, HasSubstr("--port N"));
    EXPECT_EQ(Run(tool, {"--prt", "3"}), 2);
    EXPECT_THAT(err_, HasSubstr("did you mean --port?"));
  }
}

}  // namespace
}  // namespace limpet
