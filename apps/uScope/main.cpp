// SPDX-License-Identifier: MIT
#include "limpet/console/tools.hpp"

int main(int argc, char** argv) {
  return limpet::RunToolMain(limpet::RunScope, "uScope", argc, argv);
}
