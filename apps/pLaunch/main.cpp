// SPDX-License-Identifier: MIT
#include "limpet/launch/launch.hpp"

int main(int argc, char** argv) {
  return limpet::RunLaunch("pLaunch", std::vector<std::string>(argv + 1, argv + argc));
}
