// SPDX-License-Identifier: MIT
#include "limpet/sweeps/refused_run.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

TEST(RefusedRun, SaysWhyAndWhereTheRestIs) {
  const TemporaryFolder folder;
  const std::filesystem::path log = folder.path() / "1.txt";
  EXPECT_EQ(RefusedRunText(1, log), "seed 1 was refused: see " + log.string());
  std::ofstream(log) << "a.moos:3: altitude_m: is missing\n";
  EXPECT_EQ(RefusedRunText(1, log), "seed 1 was refused: a.moos:3: altitude_m: is missing");
  std::ofstream(log) << "\na.moos:3: altitude_m: is missing\nlimpet: more\n";
  EXPECT_EQ(RefusedRunText(1, log),
            "seed 1 was refused: a.moos:3: altitude_m: is missing (1 more "
            "line in " +
                log.string() + ")");
}

}  // namespace
}  // namespace limpet
