// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_format.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CalendarText, NamesDaysAsCtimeDoes) {
  EXPECT_EQ(CalendarText(Seconds(1795245600.0)), "Sat Nov 21 07:20:00 2026");
  EXPECT_EQ(CalendarText(Seconds(951782400.0)), "Tue Feb 29 00:00:00 2000");
}

}  // namespace
}  // namespace limpet
