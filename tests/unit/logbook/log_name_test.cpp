// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_name.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(LogName, PackedLogsAreLogsAndTheirIndexesAreNot) {
  EXPECT_TRUE(IsAlogName("runs/change/log.alog"));
  EXPECT_TRUE(IsAlogName("log.alog.gz"));
  EXPECT_FALSE(IsAlogName("log.slog"));
  EXPECT_FALSE(IsAlogName("log.alog/notes.txt"));
}

}  // namespace
}  // namespace limpet
