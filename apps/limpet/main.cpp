// SPDX-License-Identifier: MIT
// limpet: one command in front of everything.
#include <csignal>
#include <string>
#include <vector>

#include "apps/limpet/command_line.hpp"
#include "limpet/core/interrupt.hpp"

namespace {

void OnSignal(int signal) {
  limpet::interrupt_requested = true;
  std::signal(signal, SIG_DFL);  // a second Ctrl-C kills
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, OnSignal);
  std::signal(SIGTERM, OnSignal);
  return limpet::RunCommandLine(std::vector<std::string>(argv + 1, argv + argc));
}
