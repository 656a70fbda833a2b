// SPDX-License-Identifier: MIT
#include "limpet/app/run_app.hpp"

int main(int argc, char** argv) { return limpet::RunApp("pSafety", argc, argv); }
