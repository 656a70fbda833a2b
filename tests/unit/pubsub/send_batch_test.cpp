// SPDX-License-Identifier: MIT
#include "limpet/pubsub/send_batch.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <list>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

namespace limpet {
namespace {

/// A socket to send on, and its other end.
class Pipe {
 public:
  Pipe() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends_.data()), 0); }
  ~Pipe() {
    ::close(ends_[0]);
    HangUp();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int descriptor() const { return ends_[0]; }
  void HangUp() {
    if (ends_[1] >= 0) {
      ::close(std::exchange(ends_[1], -1));
    }
  }
  void Fill() const {
    const std::string block(4096, 'x');
    while (::send(ends_[0], block.data(), block.size(), MSG_NOSIGNAL) > 0) {
    }
  }
  [[nodiscard]] std::string Heard() const {
    std::string text(4096, '\0');
    const ssize_t count = ::recv(ends_[1], text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return text;
  }

 private:
  std::array<int, 2> ends_{};
};

ByteView Bytes(const std::string& text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

class SendBatchTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!batch_.is_open()) {
      GTEST_SKIP() << "this system has no io_uring, or forbids it";
    }
  }
  SendBatch batch_;
};

TEST_F(SendBatchTest, SendsToEachWhatIsItsOwnHoweverManyTheyAre) {
  std::list<Pipe> pipes;
  std::list<std::string> texts;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 150; ++i) {
      texts.push_back("for " + std::to_string(i) + " in round " + std::to_string(round));
      batch_.Add(pipes.emplace_back().descriptor(), Bytes(texts.back()));
    }
    const std::span<const int> taken = batch_.Send();
    ASSERT_EQ(taken.size(), pipes.size());
    auto text = texts.begin();
    auto count = taken.begin();
    for (const Pipe& pipe : pipes) {
      EXPECT_EQ(*count++, static_cast<int>(text->size()));
      EXPECT_EQ(pipe.Heard(), *text++);
    }
    pipes.clear();
    texts.clear();
  }
}

TEST_F(SendBatchTest, AFullSocketOrOneHungUpTakesNothingFromTheOthers) {
  Pipe full, gone, open;
  full.Fill();
  gone.HangUp();
  const std::string text = "hello";
  for (const Pipe* pipe : {&full, &gone, &open}) {
    batch_.Add(pipe->descriptor(), Bytes(text));
  }
  EXPECT_THAT(batch_.Send(), testing::ElementsAre(-EAGAIN, -EPIPE, 5));
  EXPECT_EQ(open.Heard(), text);
  EXPECT_THAT(batch_.Send(), testing::IsEmpty()) << "what was sent is not sent again";
}

TEST_F(SendBatchTest, ASocketThatHasRoomForAPartTakesThePart) {
  const Pipe pipe;
  const std::string text(std::size_t{8} << 20, 'x');
  batch_.Add(pipe.descriptor(), Bytes(text));
  const std::span<const int> taken = batch_.Send();
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_GT(taken[0], 0);
  EXPECT_LT(taken[0], static_cast<int>(text.size()));
}

}  // namespace
}  // namespace limpet
