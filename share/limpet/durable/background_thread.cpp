// SPDX-License-Identifier: MIT
#include "limpet/durable/background_thread.hpp"

#include <csignal>
#include <utility>

namespace limpet {

std::thread BackgroundThread(std::function<void()> run) {
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(run));
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace limpet
