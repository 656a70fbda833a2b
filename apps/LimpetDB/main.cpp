// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/limpet_db.hpp"

int main(int argc, char** argv) { return limpet::RunDatabase(argc, argv); }
